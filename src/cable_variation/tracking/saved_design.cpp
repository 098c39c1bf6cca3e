#include <cable_variation/tracking/saved_design.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/util/encoded_word.h>
#include <cable_variation/util/number_text.h>
#include <cable_variation/util/text_tokens.h>

namespace cable_variation {
namespace {

constexpr char kEnd[] = "end";  // the last line: all of the text is there

// Every number of what an edit changes, in one order for writing and for reading.
template <typename Vector, typename Visit>
void visitVector(Vector& vector, Visit& visit) {
  for (int i = 0; i < 3; ++i) visit(vector[i]);
}

template <typename PoseType, typename Visit>
void visitPose(PoseType& pose, Visit& visit) {
  visitVector(pose.position, visit);
  for (int i = 0; i < 4; ++i) visit(pose.orientation.coeffs()[i]);
}

template <typename SectionType, typename Visit>
void visitSection(SectionType& section, Visit& visit) {
  for (auto* number : {&section.EA, &section.GA_y, &section.GA_z, &section.GJ, &section.EI_y, &section.EI_z,
                       &section.mass_per_length, &section.radius, &section.young_modulus,
                       &section.shear_modulus, &section.width, &section.height}) {
    visit(*number);
  }
}

template <typename PointType, typename Visit>
void visitPoint(PointType& point, Visit& visit) {
  visit(point.arc_length);
  visitPose(point.pose, visit);
  visitVector(point.tangent, visit);
  visitVector(point.second_derivative, visit);
  visitVector(point.darboux, visit);
}

class Writer {
 public:
  Writer& line(const char* kind) {
    if (!text_.empty()) text_ += '\n';
    text_ += kind;
    return *this;
  }
  Writer& word(const std::string& text) {
    text_ += ' ';
    text_ += encodedWord(text);
    return *this;
  }
  Writer& index(std::size_t value) {
    text_ += ' ';
    text_ += std::to_string(value);
    return *this;
  }
  void operator()(double value) {
    text_ += ' ';
    text_ += numberText(value);
  }
  std::string finish() {
    line(kEnd);
    return text_ + "\n";
  }

 private:
  std::string text_;
};

/// Lines of a text, each a kind and its words.
class Reader {
 public:
  explicit Reader(std::string_view text) : tokens_(text) {}

  /// The next line's kind; at the text's end it is not whole.
  std::string_view line() {
    const auto kind = tokens_.next();
    if (!kind) fail("the text is cut off");
    return *kind;
  }
  std::string word() { return decodedWord(next()); }
  double number() {
    const std::string_view text = next();
    const auto value = numberIn(text);
    if (!value) fail(quoted(text) + "; expected a number");
    return *value;
  }
  /// Below `count`.
  std::size_t index(std::size_t count) {
    const double value = number();
    if (!(value >= 0.0 && value < static_cast<double>(count) && value == std::floor(value)))
      fail(numberText(value) + "; expected one of " + std::to_string(count));
    return static_cast<std::size_t>(value);
  }
  void operator()(double& value) { value = number(); }
  void requireLineEnd() {
    if (const auto more = tokens_.nextInLine()) fail(quoted(*more) + " is one too many");
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument("line " + std::to_string(tokens_.line()) + ": " + what);
  }

 private:
  std::string_view next() {
    const auto word = tokens_.nextInLine();
    if (!word) fail("something is missing at its end");
    return *word;
  }

  TextTokens tokens_;
};

void writeCable(const Cable& cable, std::size_t index, bool added, Writer& writer) {
  if (added) writer.line("new_cable").word(cable.name);
  writer.line("cable").index(index)(cable.length);
  for (const SectionAt& knot : cable.sections) {
    writer.line("section").index(index)(knot.arc_length);
    visitSection(knot.section, writer);
  }
  for (const RestCurvatureAt& knot : cable.rest_curvature) {
    writer.line("rest").index(index)(knot.arc_length);
    visitVector(knot.curvature, writer);
  }
}

// Of a clip that was added all is written, of others what may have been edited.
void writeClip(const Clip& clip, const ClipMount& mount, std::size_t index, bool added, Writer& writer) {
  if (added) {
    writer.line("added").word(clip.name).word(clip.type).word(mount.component).index(clip.cable);
  } else {
    writer.line("clip").index(index);
  }
  writer.index(clip.attached ? 1 : 0)(clip.arc_length);
  visitPose(mount.pose, writer);
}

void writeShape(const Harness& harness, const Equilibrium& shape, Writer& writer) {
  if (!shape.converged()) return;
  for (std::size_t i = 0; i < shape.shapes.size(); ++i) {
    for (const ShapePoint& point : shape.shapes[i].points) {
      writer.line("point").index(i);
      visitPoint(point, writer);
    }
  }
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const Clip& clip = harness.clips[i];
    if (clip.attached && clip.constraint.slides)
      writer.line("slid").index(i)(shape.clip_reactions[i].arc_length);
  }
}

/// Puts what the lines say into a design.
class DesignReader {
 public:
  DesignReader(std::string_view text, const Scene& loaded) : reader_(text) {
    saved_.design.scene = loaded;
    for (Cable& cable : harness().cables) {
      cable.sections.clear();
      cable.rest_curvature.clear();
      saved_.shape.shapes.push_back({cable.name, 0.0, {}});
    }
  }

  SavedDesign read() {
    for (std::string_view kind = reader_.line(); kind != kEnd; kind = reader_.line()) {
      if (!(readNominal(kind) || readCable(kind) || readClip(kind) || readPlace(kind) || readShape(kind)))
        reader_.fail(quoted(kind) + " is nothing that a design has");
      reader_.requireLineEnd();
    }
    for (std::size_t i = 0; i < harness().clips.size(); ++i) mount(i);
    if (!harness().cables.empty()) validate(harness());
    for (const CableShape& shape : saved_.shape.shapes) {
      if (shape.points.size() >= 2) continue;
      saved_.shape = {};
      break;
    }
    return std::move(saved_);
  }

 private:
  Harness& harness() { return saved_.design.scene.harness; }
  Cable& nextCable() { return harness().cables[reader_.index(harness().cables.size())]; }

  bool readNominal(std::string_view kind) {
    std::vector<DesignVariable>& variables = saved_.design.scene.design_variables;
    if (kind == "nominal") {
      DesignVariable& variable = variables[reader_.index(variables.size())];
      variable.nominal = reader_.number();
    } else if (kind == "shifted") {
      const std::string& name = variables[reader_.index(variables.size())].name;
      saved_.design.shifted[name] = reader_.number();
    } else {
      return false;
    }
    return true;
  }

  bool readCable(std::string_view kind) {
    if (kind == "new_cable") {
      Cable& cable = harness().cables.emplace_back();
      cable.name = reader_.word();
      saved_.shape.shapes.push_back({cable.name, 0.0, {}});
    } else if (kind == "cable") {
      Cable& cable = nextCable();
      cable.length = reader_.number();
    } else if (kind == "section") {
      SectionAt& knot = nextCable().sections.emplace_back();
      knot.arc_length = reader_.number();
      visitSection(knot.section, reader_);
    } else if (kind == "rest") {
      RestCurvatureAt& knot = nextCable().rest_curvature.emplace_back();
      knot.arc_length = reader_.number();
      visitVector(knot.curvature, reader_);
    } else {
      return false;
    }
    return true;
  }

  bool readClip(std::string_view kind) {
    std::vector<Clip>& clips = harness().clips;
    std::vector<ClipMount>& mounts = saved_.design.scene.clip_mounts;
    std::size_t index = clips.size();
    if (kind == "clip") {
      index = reader_.index(clips.size());
    } else if (kind == "added") {
      Clip clip;
      clip.name = reader_.word();
      clip.type = reader_.word();
      clip.constraint = addedConstraint(clip.type);
      mounts.push_back({reader_.word(), {}});
      clip.cable = reader_.index(harness().cables.size());
      clips.push_back(std::move(clip));
    } else {
      return false;
    }
    clips[index].attached = reader_.index(2) == 1;
    clips[index].arc_length = reader_.number();
    visitPose(mounts[index].pose, reader_);
    return true;
  }

  ClipConstraint addedConstraint(const std::string& type) const {
    for (const ClipPresetTraits& traits : clipPresets()) {
      if (type == traits.name && canBeAdded(traits)) return traits.constraint({});
    }
    reader_.fail("no clip of type '" + type + "' can be added");
  }

  bool readPlace(std::string_view kind) {
    if (kind == "shift") {
      const std::vector<Component>& components = saved_.design.scene.components;
      const std::string& name = components[reader_.index(components.size())].name;
      Pose& shift = saved_.design.shifts[name];
      visitPose(shift, reader_);
      requireUnit(shift, "component '" + name + "'");
    } else if (kind == "joint") {
      Joint& joint = harness().joints[reader_.index(harness().joints.size())];
      joint.parent_arc_length = reader_.number();
      joint.child_arc_length = reader_.number();
    } else if (kind == "load") {
      PointLoad& load = harness().loads[reader_.index(harness().loads.size())];
      load.arc_length = reader_.number();
    } else {
      return false;
    }
    return true;
  }

  bool readShape(std::string_view kind) {
    if (kind == "point") {
      std::vector<CableShape>& shapes = saved_.shape.shapes;
      visitPoint(shapes[reader_.index(shapes.size())].points.emplace_back(), reader_);
    } else if (kind == "slid") {
      const std::size_t clip = reader_.index(harness().clips.size());
      saved_.shape.slid.emplace_back(clip, reader_.number());
    } else {
      return false;
    }
    return true;
  }

  void mount(std::size_t index) {
    Clip& clip = harness().clips[index];
    if (!isMounted(clip)) return;
    const ClipMount& mount = saved_.design.scene.clip_mounts[index];
    requireUnit(mount.pose, "clip '" + clip.name + "'");
    clip.pose = componentPose(saved_.design.scene, mount.component) * mount.pose;
  }

  static void requireUnit(const Pose& pose, const std::string& what) {
    if (std::abs(pose.orientation.norm() - 1.0) > 1e-6)
      throw std::invalid_argument(what + ": its quaternion is not a unit one");
  }

  Reader reader_;
  SavedDesign saved_;
};

}  // namespace

std::string savedDesignText(const Design& design, const Scene& loaded, const Equilibrium& shape) {
  const std::size_t known = loaded.harness.clips.size();
  const Scene& scene = design.scene;
  const Harness& harness = scene.harness;
  Writer writer;
  for (std::size_t i = 0; i < scene.design_variables.size(); ++i) {
    const DesignVariable& variable = scene.design_variables[i];
    writer.line("nominal").index(i)(variable.nominal);
    const auto shifted = design.shifted.find(variable.name);
    if (shifted != design.shifted.end()) writer.line("shifted").index(i)(shifted->second);
  }
  for (std::size_t i = 0; i < scene.components.size(); ++i) {
    const auto shift = design.shifts.find(scene.components[i].name);
    if (shift == design.shifts.end()) continue;
    writer.line("shift").index(i);
    visitPose(shift->second, writer);
  }
  for (std::size_t i = 0; i < harness.cables.size(); ++i)
    writeCable(harness.cables[i], i, i >= loaded.harness.cables.size(), writer);
  for (std::size_t i = 0; i < harness.joints.size(); ++i) {
    writer.line("joint").index(i)(harness.joints[i].parent_arc_length);
    writer(harness.joints[i].child_arc_length);
  }
  for (std::size_t i = 0; i < harness.loads.size(); ++i)
    writer.line("load").index(i)(harness.loads[i].arc_length);
  for (std::size_t i = 0; i < harness.clips.size(); ++i)
    writeClip(harness.clips[i], scene.clip_mounts[i], i, i >= known, writer);
  writeShape(harness, shape, writer);
  return writer.finish();
}

SavedDesign readSavedDesign(const std::string& text, const Scene& loaded) {
  return DesignReader(text, loaded).read();
}

Equilibrium solveSaved(EquilibriumSolver& solver, const Harness& harness, const SavedShape& shape) {
  if (shape.shapes.size() == harness.cables.size() && !shape.shapes.empty()) {
    Harness there = harness;
    for (const auto& [clip, arc_length] : shape.slid) there.clips.at(clip).arc_length = arc_length;
    EquilibriumSolver from = solver;
    Equilibrium equilibrium = from.solveFrom(there, shape.shapes);
    if (equilibrium.converged() && !shape.slid.empty()) equilibrium = from.update(harness);
    if (equilibrium.converged()) {
      solver = std::move(from);
      return equilibrium;
    }
  }
  return solver.solve(harness);
}

}  // namespace cable_variation
