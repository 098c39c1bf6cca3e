#include <hunt/scene_writer.h>

#include <sstream>

namespace cable_variation::hunt {
namespace {

std::ostream& operator<<(std::ostream& out, const Eigen::Vector3d& v) {
  return out << '[' << v.x() << ", " << v.y() << ", " << v.z() << ']';
}

std::ostream& operator<<(std::ostream& out, const Eigen::Quaterniond& q) {
  return out << "[" << q.w() << ", " << q.x() << ", " << q.y() << ", " << q.z() << ']';
}

std::ostream& operator<<(std::ostream& out, const Section& s) {
  return out << "{EA: " << s.EA << ", GA_y: " << s.GA_y << ", GA_z: " << s.GA_z << ", EI_y: " << s.EI_y
             << ", EI_z: " << s.EI_z << ", GJ: " << s.GJ << ", mass_per_length: " << s.mass_per_length
             << ", radius: " << s.radius << '}';
}

std::ostream& operator<<(std::ostream& out, const std::array<ClipFreedom, 3>& freedoms) {
  const char* separator = "[";
  for (const ClipFreedom& freedom : freedoms) {
    out << separator;
    if (freedom.kind == ClipFreedom::Kind::locked) out << "locked";
    if (freedom.kind == ClipFreedom::Kind::free) out << "free";
    if (freedom.kind == ClipFreedom::Kind::sprung) out << "{stiffness: " << freedom.stiffness << '}';
    separator = ", ";
  }
  return out << ']';
}

void write(std::ostream& out, const Cable& cable) {
  out << "- name: " << cable.name << "\n  length: " << cable.length << '\n';
  if (cable.sections.size() == 1) {
    out << "  stiffness: " << cable.sections.front().section << '\n';
  } else {
    out << "  sections:\n";
    for (const SectionAt& at : cable.sections) {
      out << "  - {at: " << at.arc_length << ", stiffness: " << at.section << "}\n";
    }
  }
  if (!cable.rest_curvature.empty()) {
    out << "  rest_shape:\n    curvature:\n";
    for (const RestCurvatureAt& at : cable.rest_curvature) {
      out << "    - {at: " << at.arc_length << ", value: " << at.curvature << "}\n";
    }
  }
  if (cable.twist) out << "  twist: " << *cable.twist << '\n';
  for (std::size_t i = 0; i < cable.via.size(); ++i) {
    out << (i == 0 ? "  via:\n" : "") << "  - " << cable.via[i] << '\n';
  }
}

void write(std::ostream& out, const Harness& harness, const Clip& clip) {
  out << "- {name: " << clip.name << ", type: general, cable: " << harness.cables[clip.cable].name
      << ", at: " << clip.arc_length << ", pose: {position: " << clip.pose.position
      << ", quaternion: " << clip.pose.orientation << "}, translation: " << clip.constraint.translation
      << ", rotation: " << clip.constraint.rotation << (clip.constraint.slides ? ", slides: true" : "")
      << "}\n";
}

void write(std::ostream& out, const Harness& harness, const Joint& joint) {
  constexpr const char* kTypes[] = {"fixed", "pivot", "hinge"};
  out << "- {name: " << joint.name << ", type: " << kTypes[static_cast<int>(joint.type)]
      << ", parent: " << harness.cables[joint.parent].name << ", at: " << joint.parent_arc_length
      << ", child: " << harness.cables[joint.child].name << ", child_at: " << joint.child_arc_length;
  if (joint.type != Joint::Type::pivot) out << ", rotation: {quaternion: " << joint.rotation << '}';
  if (joint.type == Joint::Type::hinge) out << ", axis: " << joint.axis;
  out << "}\n";
}

}  // namespace

std::string sceneOf(const Harness& harness, double accuracy, const std::string& remark) {
  std::ostringstream out;
  out.precision(17);
  std::istringstream lines(remark);
  for (std::string line; std::getline(lines, line);) out << "# " << line << '\n';
  out << "gravity: " << harness.gravity << "\naccuracy: " << accuracy << "\ncables:\n";
  for (const Cable& cable : harness.cables) write(out, cable);
  out << "clips:\n";
  for (const Clip& clip : harness.clips) write(out, harness, clip);
  if (!harness.joints.empty()) out << "joints:\n";
  for (const Joint& joint : harness.joints) write(out, harness, joint);
  if (!harness.loads.empty()) out << "loads:\n";
  for (const PointLoad& load : harness.loads) {
    out << "- {name: " << load.name << ", cable: " << harness.cables[load.cable].name
        << ", at: " << load.arc_length << ", force: " << load.force << ", moment: " << load.moment << "}\n";
  }
  return out.str();
}

}  // namespace cable_variation::hunt
