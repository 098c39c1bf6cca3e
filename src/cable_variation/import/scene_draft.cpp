#include <cable_variation/import/scene_draft.h>

#include <cctype>
#include <cmath>

#include <cable_variation/scene_file/value_text.h>
#include <cable_variation/util/number_text.h>
#include <cable_variation/util/readable_text.h>

namespace cable_variation {
namespace {

constexpr int kDigits = 9;

std::string comment(const std::string& text, const std::string& indent = "") {
  return text.empty() ? std::string() : indent + "# " + readableText(text) + "\n";
}

// A name is quoted if YAML would take it for something else, as a number.
std::string nameText(const std::string& name) { return "\"" + name + "\""; }

// Any text, between quotes.
std::string quotedText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : readableText(text)) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

std::string stiffnessText(const Section& section) {
  const auto number = [](double value) { return numberText(value, kDigits); };
  return "{EA: " + number(section.EA) + ", GA: " + number(section.GA_y) + ", EI: " + number(section.EI_y) +
         ", GJ: " + number(section.GJ) + ", mass_per_length: " + number(section.mass_per_length) +
         ", radius: " + lengthText(section.radius) + "}";
}

bool sameSection(const Section& a, const Section& b) { return stiffnessText(a) == stiffnessText(b); }

std::string placeText(double at, double length) {
  if (at <= 0.0) return "start";
  return at >= length ? "end" : lengthText(at);
}

void writePoints(std::string& text, const std::vector<Eigen::Vector3d>& points, const std::string& indent) {
  for (const Eigen::Vector3d& point : points) text += indent + "- " + positionText(point) + "\n";
}

void writeCable(std::string& text, const SceneDraft::Cable& cable) {
  for (const SceneDraft::Part& part : cable.parts) text += comment(part.comment, "  ");
  text += "  - name: " + nameText(cable.name) + "\n    length: " + lengthText(cable.length) + "\n";
  bool uniform = true;
  for (const SceneDraft::Part& part : cable.parts)
    uniform = uniform && sameSection(part.section, cable.parts.front().section);
  if (uniform) {
    text += "    stiffness: " + stiffnessText(cable.parts.front().section) + "\n";
  } else {
    text += "    sections:\n";
    double begin = 0.0;
    for (std::size_t i = 0; i < cable.parts.size(); ++i) {
      const SceneDraft::Part& part = cable.parts[i];
      const bool goes_on =
          i + 1 < cable.parts.size() && sameSection(part.section, cable.parts[i + 1].section);
      if (goes_on) continue;  // the parts are one
      for (const double at : {begin, part.end})
        text += "      - {at: " + placeText(at, cable.length) +
                ", stiffness: " + stiffnessText(part.section) + "}\n";
      begin = part.end;
    }
  }
  if (!cable.rest_curvature.empty()) text += "    rest_shape:\n      curvature:\n";
  for (const RestCurvatureAt& knot : cable.rest_curvature) {
    text += "        - {at: " + placeText(knot.arc_length, cable.length) + ", value: [";
    for (int i = 0; i < 3; ++i) text += (i > 0 ? ", " : "") + numberText(knot.curvature[i], kDigits);
    text += "]}\n";
  }
  if (!cable.via.empty()) {
    text += "    via:\n";
    writePoints(text, cable.via, "      ");
  }
}

}  // namespace

std::string sceneText(const SceneDraft& draft) {
  std::string text;
  for (const std::string& line : draft.head) text += line.empty() ? "#\n" : comment(line);
  text += "\naccuracy: " + lengthText(draft.accuracy) + "\n";
  if (!draft.components.empty()) text += "\ncomponents:\n";
  for (const SceneDraft::Component& component : draft.components) {
    text += comment(component.comment, "  ");
    text += "  - {name: " + nameText(component.name) + ", pose: " + poseText(component.pose) + "}\n";
  }
  text += "\ncables:\n";
  for (const SceneDraft::Cable& cable : draft.cables) writeCable(text, cable);
  if (!draft.clips.empty()) text += "\nclips:\n";
  for (const SceneDraft::Clip& clip : draft.clips) {
    const SceneDraft::Cable& cable = draft.cables[clip.cable];
    text += comment(clip.comment, "  ");
    text += "  - {name: " + nameText(clip.name) + ", type: " + clip.type +
            (clip.more.empty() ? "" : ", " + clip.more) + ", cable: " + nameText(cable.name) +
            ", at: " + placeText(clip.at, cable.length) + ", component: " + nameText(clip.component) +
            ", pose: " + poseText(clip.pose) + "}\n";
  }
  if (!draft.joints.empty()) text += "\njoints:\n";
  for (const SceneDraft::Joint& joint : draft.joints) {
    const SceneDraft::Cable& parent = draft.cables[joint.parent];
    text += "  - {name: " + nameText(joint.name) + ", type: fixed, parent: " + nameText(parent.name) +
            ", at: " + placeText(joint.at, parent.length) +
            ", child: " + nameText(draft.cables[joint.child].name) +
            ", child_at: " + (joint.child_end ? "end" : "start") + ", rotation: {" +
            rotationText(joint.rotation) + "}}\n";
  }
  if (!draft.variables.empty()) text += "\ndesign_variables:\n";
  for (const SceneDraft::Variable& variable : draft.variables)
    text += "  - {name: " + nameText(variable.name) + ", " + variable.rest + "}\n";
  if (!draft.routes.empty()) text += "\nmeasures:\n";
  for (const SceneDraft::Route& route : draft.routes) {
    const SceneDraft::Cable& cable = draft.cables[route.cable];
    text += "  - name: " + nameText(route.name) +
            "\n    type: route_deviation\n    segment: " + quotedText(route.segment) +
            "\n    cable: " + nameText(cable.name) + "\n    from: " + placeText(route.from, cable.length) +
            "\n    to: " + placeText(route.to, cable.length) + "\n";
    if (route.limit) text += "    upper: " + lengthText(*route.limit) + "\n";
    text += "    route:\n";
    writePoints(text, route.points, "      ");
  }
  return text;
}

std::string sceneName(const std::string& text) {
  constexpr std::size_t kLongest = 150;
  std::string name;
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
    name += plain ? c : '_';
    if (name.size() == kLongest) break;
  }
  return name.empty() ? "_" : name;
}

}  // namespace cable_variation
