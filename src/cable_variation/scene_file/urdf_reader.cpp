#include <cable_variation/scene_file/urdf_reader.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <cable_variation/geometry/body/primitives.h>
#include <cable_variation/scene_file/fault_list.h>
#include <cable_variation/scene_file/urdf_structure.h>
#include <cable_variation/util/name_list.h>
#include <cable_variation/util/quantity.h>
#include <cable_variation/util/regular_file.h>
#include <cable_variation/util/xml_size.h>

namespace cable_variation {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// Keeps what the URDF parser says in this thread while it lives, instead of printing it.
class ParserMessages : public console_bridge::OutputHandler {
 public:
  ParserMessages() : lock_(mutex()) { console_bridge::useOutputHandler(this); }
  ~ParserMessages() override { console_bridge::restorePreviousOutputHandler(); }
  ParserMessages(const ParserMessages&) = delete;
  ParserMessages& operator=(const ParserMessages&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    const bool own = std::this_thread::get_id() == thread_;  // tf and others log this way too
    if (own && level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) errors_.push_back(text);
  }
  const std::vector<std::string>& errors() const { return errors_; }

 private:
  static std::mutex& mutex() {  // the handler is one for the whole process
    static std::mutex instance;
    return instance;
  }
  std::lock_guard<std::mutex> lock_;
  std::thread::id thread_ = std::this_thread::get_id();
  std::vector<std::string> errors_;
};

/// A URDF's tree of links and joints. Its strings have a mark instead of %.
class UrdfModel {
 public:
  /// Null after a fault.
  UrdfModel(const std::string& path, const InputLimits& limits, std::vector<std::string>& faults) {
    std::string text;
    try {
      const std::string original = readWhole(path, limits.urdf_bytes);
      requireXmlSize(original, limits.xml_parts);
      mark_ = unusedCharacter(original);
      text = checkedUrdf(original, mark_, faults);
    } catch (const std::invalid_argument& error) {
      faults.emplace_back(error.what());
    }
    if (!text.empty()) parse(text, faults);
  }
  ~UrdfModel() { reset(); }
  UrdfModel(const UrdfModel&) = delete;
  UrdfModel& operator=(const UrdfModel&) = delete;

  const urdf::ModelInterface* get() const { return model_.get(); }
  std::string marked(const std::string& text) const { return replaced(text, "%", mark_); }
  std::string unmarked(const std::string& text) const { return replaced(text, mark_, "%"); }

 private:
  void parse(const std::string& text, std::vector<std::string>& faults) {
    ParserMessages messages;
    try {
      model_ = urdf::parseURDF(text);
    } catch (const std::exception& error) {
      faults.push_back(unmarked(error.what()));
    }
    if (model_ && messages.errors().empty()) return;
    const std::string said = unmarked(joined(messages.errors()));
    faults.push_back(said.empty() ? "it is no URDF" : said);
    reset();
  }

  // A link holds its children. One lets go of them first, for a long chain would end in a deep recursion.
  void reset() {
    if (!model_) return;
    for (const auto& entry : model_->links_) entry.second->child_links.clear();
    model_.reset();
  }

  urdf::ModelInterfaceSharedPtr model_;
  std::string mark_;
};

Pose toPose(const urdf::Pose& pose) {
  const auto& r = pose.rotation;
  return {{pose.position.x, pose.position.y, pose.position.z},
          Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized()};
}

class UrdfReader {
 public:
  UrdfReader(const UrdfModel& model, const std::map<std::string, JointPosition>& positions,
             const MeshLoader& load_mesh)
      : names_(model), model_(*model.get()), load_mesh_(load_mesh) {
    for (const auto& [name, position] : positions) positions_[names_.marked(name)] = position;
  }

  std::vector<UrdfLink> read(std::vector<std::string>& faults, std::vector<std::string>& warnings) {
    checkPositions();
    addLinks();
    for (const std::string& fault : faults_) faults.push_back(names_.unmarked(fault));
    for (const std::string& warning : warnings_) warnings.push_back(names_.unmarked(warning));
    return std::move(links_);
  }

 private:
  void checkPositions() {
    std::vector<std::string> movable;
    for (const auto& [name, joint] : model_.joints_) {
      if (joint->type != urdf::Joint::FIXED && !joint->mimic) movable.push_back(name);
    }
    for (const auto& entry : positions_) {
      const auto joint = model_.getJoint(entry.first);
      if (!joint) {
        faults_.push_back("there is no joint '" + entry.first + "'" + didYouMean(entry.first, movable));
      } else if (joint->mimic) {
        faults_.push_back("joint '" + entry.first + "' follows '" + joint->mimic->joint_name +
                          "'; expected a position of that one");
      } else if (joint->type == urdf::Joint::FIXED) {
        faults_.push_back("joint '" + entry.first + "' is fixed; it takes no position");
      } else {
        const bool prismatic = joint->type == urdf::Joint::PRISMATIC;
        const auto wrong = prismatic ? JointPosition::Unit::radian : JointPosition::Unit::metre;
        if (entry.second.unit == wrong) {
          faults_.push_back("joint '" + entry.first + "' has the wrong unit; expected " +
                            (prismatic ? "a length" : "an angle"));
        }
        checkTurns(entry.first, *joint, entry.second);
      }
    }
  }

  void checkTurns(const std::string& name, const urdf::Joint& joint, const JointPosition& position) {
    constexpr double kTurn = 2.0 * M_PI;
    const bool turns = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
    if (turns && position.unit == JointPosition::Unit::none && std::abs(position.value) > kTurn) {
      warnings_.push_back("joint '" + name + "' is at " + shortNumber(position.value) +
                          " without a unit, in rad; in deg?");
    }
  }

  // Whose position counts, and where that puts the joint.
  void setPosition(const urdf::Joint& joint, LinkJoint& result, int depth = 0) {
    constexpr int kLongestChain = 32;
    if (!joint.mimic) {
      result.driver = names_.unmarked(joint.name);
      const auto given = positions_.find(joint.name);
      result.position = given == positions_.end() ? 0.0 : given->second.value;
      return;
    }
    const auto leader = model_.getJoint(joint.mimic->joint_name);
    if (!leader || depth > kLongestChain) {
      faults_.push_back("joint '" + joint.name + "' mimics '" + joint.mimic->joint_name + "', which " +
                        (leader ? "mimics it in turn" : "is not there"));
      return;
    }
    setPosition(*leader, result, depth + 1);
    const double multiplier = joint.mimic->multiplier, offset = joint.mimic->offset;
    result.multiplier *= multiplier;
    result.offset = multiplier * result.offset + offset;
    result.position = multiplier * result.position + offset;
  }

  LinkJoint readJoint(const urdf::Joint& joint) {
    LinkJoint result;
    result.name = names_.unmarked(joint.name);
    result.origin = toPose(joint.parent_to_joint_origin_transform);
    if (joint.type == urdf::Joint::FIXED) return result;
    if (joint.type == urdf::Joint::FLOATING || joint.type == urdf::Joint::PLANAR) {
      faults_.push_back("joint '" + joint.name + "' is " +
                        (joint.type == urdf::Joint::PLANAR ? "planar" : "floating") +
                        "; expected fixed, revolute, continuous or prismatic");
      return result;
    }
    setPosition(joint, result);
    if (joint.type != urdf::Joint::CONTINUOUS && joint.limits) {
      result.lower = joint.limits->lower;
      result.upper = joint.limits->upper;
    }
    if (!(result.position >= result.lower && result.position <= result.upper)) {
      faults_.push_back("joint '" + joint.name + "' at " + shortNumber(result.position) +
                        " is out of its limits " + shortNumber(result.lower) + " to " +
                        shortNumber(result.upper) + "; expected a position within them in joint_positions");
    }
    const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
    if (!(axis.norm() > 0.0)) {
      faults_.push_back("joint '" + joint.name + "' has an axis of length 0");
    } else {
      const bool slides = joint.type == urdf::Joint::PRISMATIC;
      result.type = slides ? LinkJoint::Type::prismatic : LinkJoint::Type::revolute;
      result.axis = axis.normalized();
    }
    return result;
  }

  // From the root on, in the order in which joints are listed, however long the chains are.
  void addLinks() {
    struct Branch {
      const urdf::Joint* joint;
      Pose parent;
    };
    std::vector<Branch> open;
    const auto add = [&](const urdf::Link& link, const Pose& pose, UrdfLink carried) {
      addLink(link, pose, std::move(carried));
      for (auto it = link.child_joints.rbegin(); it != link.child_joints.rend(); ++it) {
        open.push_back({it->get(), pose});
      }
    };
    add(*model_.getRoot(), Pose(), {});
    while (!open.empty()) {
      const auto [joint, parent] = open.back();
      open.pop_back();
      UrdfLink carried;
      carried.parent = names_.unmarked(joint->parent_link_name);
      carried.joint = readJoint(*joint);
      const Pose pose = parent * carried.joint->origin * jointMotion(*carried.joint, carried.joint->position);
      add(*model_.getLink(joint->child_link_name), pose, std::move(carried));
    }
  }

  void addLink(const urdf::Link& link, const Pose& pose, UrdfLink result) {
    result.name = names_.unmarked(link.name);
    result.pose = pose;
    if (!link.visual_array.empty()) {
      for (const auto& visual : link.visual_array) addGeometry(link.name, *visual, colorOf(*visual), result);
    } else {
      for (const auto& collision : link.collision_array)
        addGeometry(link.name, *collision, Visual().color, result);
    }
    links_.push_back(std::move(result));
  }

  static Eigen::Vector4d colorOf(const urdf::Visual& visual) {
    if (!visual.material) return Visual().color;
    const urdf::Color& c = visual.material->color;
    const Eigen::Vector4d color(static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b),
                                static_cast<double>(c.a));
    return color.isZero() ? Visual().color : color;  // all zero: a texture only
  }

  template <typename Shape>  // urdf::Visual or urdf::Collision
  void addGeometry(const std::string& link, const Shape& shape, const Eigen::Vector4d& color,
                   UrdfLink& result) {
    Visual visual;
    visual.name = result.name;
    visual.pose = toPose(shape.origin);
    visual.color = color;
    try {
      if (!shape.geometry) throw std::invalid_argument("its geometry is missing");
      const Pose in_root = result.pose * visual.pose;
      if (!in_root.position.allFinite() || !in_root.orientation.coeffs().allFinite()) {
        throw std::invalid_argument("its origin is not finite");
      }
      setMesh(*shape.geometry, visual);
      result.visuals.push_back(std::move(visual));
    } catch (const std::invalid_argument& error) {
      faults_.push_back("link '" + link + "': " + error.what());
    }
  }

  void setMesh(const urdf::Geometry& geometry, Visual& visual) {
    if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(&geometry)) {
      visual.mesh_scale = {mesh->scale.x, mesh->scale.y, mesh->scale.z};
      const LoadedMesh loaded = load_mesh_(names_.unmarked(mesh->filename), visual.mesh_scale);
      visual.mesh = loaded.mesh;
      visual.mesh_resource = loaded.url;
    } else if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry)) {
      visual.mesh = std::make_shared<TriangleMesh>(boxMesh({box->dim.x, box->dim.y, box->dim.z}));
    } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry)) {
      visual.mesh = std::make_shared<TriangleMesh>(cylinderMesh(cylinder->radius, cylinder->length));
    } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&geometry)) {
      visual.mesh = std::make_shared<TriangleMesh>(sphereMesh(sphere->radius));
    } else {
      throw std::invalid_argument("its geometry is neither mesh, box, cylinder nor sphere");
    }
  }

  const UrdfModel& names_;
  const urdf::ModelInterface& model_;
  std::map<std::string, JointPosition> positions_;
  const MeshLoader& load_mesh_;
  std::vector<std::string> faults_;
  std::vector<std::string> warnings_;
  std::vector<UrdfLink> links_;
};

}  // namespace

std::vector<UrdfLink> readUrdfLinks(const std::string& path,
                                    const std::map<std::string, JointPosition>& joint_positions,
                                    const MeshLoader& load_mesh, std::vector<std::string>& faults,
                                    std::vector<std::string>& warnings, const InputLimits& limits) {
  const UrdfModel model(path, limits, faults);
  if (!model.get()) return {};
  std::vector<UrdfLink> links = UrdfReader(model, joint_positions, load_mesh).read(faults, warnings);
  const bool seen =
      std::any_of(links.begin(), links.end(), [](const UrdfLink& link) { return !link.visuals.empty(); });
  if (!seen && faults.empty()) faults.emplace_back("none of its links has a geometry");
  return links;
}

std::vector<Visual> readUrdf(const std::string& path,
                             const std::map<std::string, JointPosition>& joint_positions,
                             const MeshLoader& load_mesh, std::vector<std::string>& faults,
                             std::vector<std::string>& warnings, const InputLimits& limits) {
  std::vector<Visual> visuals;
  for (UrdfLink& link : readUrdfLinks(path, joint_positions, load_mesh, faults, warnings, limits)) {
    for (Visual& visual : link.visuals) {
      visual.pose = link.pose * visual.pose;
      visuals.push_back(std::move(visual));
    }
  }
  return visuals;
}

}  // namespace cable_variation
