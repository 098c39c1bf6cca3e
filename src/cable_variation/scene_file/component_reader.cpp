#include <cmath>
#include <set>
#include <stdexcept>

#include <cable_variation/geometry/mesh/mesh_reader.h>
#include <cable_variation/scene/locating_scheme.h>
#include <cable_variation/scene/resource_address.h>
#include <cable_variation/scene_file/pose_reader.h>
#include <cable_variation/scene_file/read_context.h>
#include <cable_variation/scene_file/urdf_reader.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

LoadedMesh loadMesh(const std::string& address, const Vector3d& scale, ReadContext& context) {
  if (!scale.allFinite() || (scale.array() == 0.0).any()) {
    throw std::invalid_argument("mesh '" + address + "' has a scale with a factor of 0");
  }
  const InputLimits& limits = context.limits;
  const ResourceFile file = findResource(address, context.find_package, limits.mesh_bytes, limits.folders);
  std::shared_ptr<const TriangleMesh>& mesh = context.meshes[file.path];
  if (!mesh) mesh = std::make_shared<TriangleMesh>(readMesh(file.path, Vector3d::Ones(), limits));
  return {scale == Vector3d::Ones() ? mesh : std::make_shared<TriangleMesh>(scaled(*mesh, scale)), file.url};
}

Vector3d readScale(const YamlCursor& cursor) {
  const Vector3d scale = cursor.isList()
                             ? cursor.vector(quantity::number)
                             : Vector3d::Constant(cursor.number(quantity::number, Range::positive())).eval();
  if ((scale.array() == 0.0).any()) cursor.fail("found a factor of 0; expected others");
  return scale;
}

Eigen::Vector4d readColor(const YamlCursor& cursor) {
  Eigen::Vector4d color = Visual().color;
  const std::vector<YamlCursor> items = cursor.items();
  if (cursor.isList() && items.size() != 3 && items.size() != 4) {
    cursor.fail("found a list of " + std::to_string(items.size()) + "; expected [r, g, b] or [r, g, b, a]");
    return color;
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    color[static_cast<int>(i)] = items[i].number(quantity::number, {0.0, 1.0, false});
  }
  return color;
}

void readMeshVisual(const YamlCursor& item, const YamlCursor& mesh, Component& component,
                    ReadContext& context) {
  Visual visual;
  visual.name = component.name;
  const std::string address = mesh.text();
  const std::size_t before = context.faults.count();
  if (const auto scale = item.find("scale")) visual.mesh_scale = readScale(*scale);
  if (const auto color = item.find("color")) visual.color = readColor(*color);
  if (address.empty() || context.faults.count() > before) return;
  try {
    const LoadedMesh loaded = loadMesh(address, visual.mesh_scale, context);
    visual.mesh = loaded.mesh;
    visual.mesh_resource = loaded.url;
    component.visuals.push_back(std::move(visual));
  } catch (const std::invalid_argument& error) {
    mesh.fail(error.what());
  }
}

JointPosition readJointPosition(const YamlCursor& cursor) {
  static const Quantity either{"an angle or a length", "", "35 deg", {0, 0, 0, 1}};
  static const Quantity bare{"a number", "", "0.5", {0, 0, 0, -99}};  // fits no unit
  const std::string text = cursor.isScalar() ? cursor.text() : std::string();
  const auto fits = [&](const Quantity& quantity) {
    try {
      parseQuantity(text, quantity);
      return true;
    } catch (const std::invalid_argument&) {
      return false;
    }
  };
  if (fits(bare)) return {cursor.number(either), JointPosition::Unit::none};
  if (fits(quantity::length)) return {cursor.number(quantity::length), JointPosition::Unit::metre};
  return {cursor.number(either), JointPosition::Unit::radian};
}

// Of a URDF whose joints move: `links` takes all but the root.
void addLinks(std::vector<UrdfLink> of, Component& root, std::vector<Component>& links) {
  if (of.empty()) return;
  const std::string root_link = of.front().name;
  const auto component_of = [&](const std::string& link) {
    return link == root_link ? root.name : root.name + "/" + link;
  };
  root.robot = root.name;
  root.visuals = std::move(of.front().visuals);
  for (std::size_t i = 1; i < of.size(); ++i) {
    Component link;
    link.name = component_of(of[i].name);
    link.parent = component_of(of[i].parent);
    link.driven_by = ComponentDriver::joint_states;
    link.robot = root.name;
    link.pose = of[i].joint->origin * jointMotion(*of[i].joint, of[i].joint->position);
    link.joint = std::move(of[i].joint);
    link.visuals = std::move(of[i].visuals);
    links.push_back(std::move(link));
  }
}

void readUrdfVisuals(const YamlCursor& item, const YamlCursor& urdf, Component& component,
                     std::vector<Component>& links, ReadContext& context) {
  std::map<std::string, JointPosition> positions;
  const std::size_t before = context.faults.count();
  if (const auto given = item.find("joint_positions")) {
    if (!given->isMap()) given->fail("expected a map from joint names to positions");
    for (const auto& [joint, value] : given->entries()) {
      if (!positions.emplace(joint, readJointPosition(value)).second) {
        value.fail("there is a position of joint '" + joint + "' already");
      }
    }
  }
  const std::string address = urdf.text();
  if (address.empty() || context.faults.count() > before) return;
  try {
    std::vector<std::string> faults, warnings;
    const MeshLoader load = [&](const std::string& mesh, const Vector3d& scale) {
      return loadMesh(mesh, scale, context);
    };
    const InputLimits& limits = context.limits;
    const std::string path = localPath(address, context.find_package, limits.urdf_bytes, limits.folders);
    if (component.driven_by == ComponentDriver::joint_states) {
      addLinks(readUrdfLinks(path, positions, load, faults, warnings, limits), component, links);
    } else {
      component.visuals = readUrdf(path, positions, load, faults, warnings, limits);
    }
    for (const std::string& fault : faults) urdf.fail("'" + address + "': " + fault);
    for (const std::string& warning : warnings) urdf.warn("'" + address + "': " + warning);
  } catch (const std::invalid_argument& error) {
    urdf.fail(error.what());
  }
}

void readLocators(const YamlCursor& list, Component& component) {
  const std::size_t before = list.faults().count();
  for (const YamlCursor& item : list.items(6)) {
    if (!item.checkKeys({"point", "direction"})) continue;
    const Vector3d point = item.vector("point", quantity::length);
    const auto direction = item.require("direction");
    component.locators.emplace_back(point, direction ? readDirection(*direction) : Vector3d::UnitX().eval());
  }
  if (list.faults().count() > before) return;
  try {
    checkLocatingScheme(component.locators);
  } catch (const std::invalid_argument& error) {
    list.fail(error.what());
  }
}

void readDriver(const YamlCursor& item, Component& component) {
  const auto driver = item.find("driven_by");
  if (!driver) return;
  component.driven_by = static_cast<ComponentDriver>(driver->choice({"scene", "tf", "joint_states"}));
  if (component.driven_by == ComponentDriver::joint_states && !item.has("urdf"))
    driver->fail("joint states drive the joints of a urdf; expected a urdf, or tf");
}

// `links` takes those of a URDF that joint states drive.
void readComponent(const YamlCursor& item, Component& component, std::vector<Component>& links,
                   ReadContext& context) {
  if (!item.checkKeys({"name", "mesh", "scale", "color", "urdf", "joint_positions", "parent", "pose",
                       "driven_by", "locators"})) {
    return;
  }
  if (component.name == "world") item.fail("'world' is the fixed frame; expected another name");
  const auto mesh = item.find("mesh");
  const auto urdf = item.find("urdf");
  if (mesh && urdf) item.fail("'mesh' and 'urdf' are both there; expected one of them");
  for (const char* key : {"scale", "color"}) {
    if (!mesh && item.has(key)) item.find(key)->fail("it goes with a mesh");
  }
  if (!urdf && item.has("joint_positions")) item.find("joint_positions")->fail("it goes with a urdf");
  if (mesh && !urdf) readMeshVisual(item, *mesh, component, context);
  readDriver(item, component);
  if (urdf && !mesh) readUrdfVisuals(item, *urdf, component, links, context);
  if (const auto parent = item.find("parent")) component.parent = parent->text();
  if (const auto pose = item.find("pose")) component.pose = readPose(*pose);
  if (const auto locators = item.find("locators")) readLocators(*locators, component);
}

// Every parent is there, and none rides on itself by way of others.
void checkParents(const std::vector<std::pair<YamlCursor, std::size_t>>& items, const ReadContext& context) {
  const std::vector<Component>& components = context.scene.components;
  std::map<std::string, const Component*> by_name;
  for (const Component& component : components) by_name.emplace(component.name, &component);
  std::set<std::string> ends;  // whose way is known to end
  for (const auto& [item, index] : items) {
    const Component& component = components[index];
    const auto parent = item.find("parent");
    if (!parent || component.parent == "world" || component.parent.empty()) continue;
    if (context.components.find(*parent) == NameTable::npos) continue;
    std::set<std::string> passed{component.name};
    std::string chain = component.name;
    bool circle = false;
    for (std::string at = component.parent; by_name.count(at) > 0 && ends.count(at) == 0;
         at = by_name.at(at)->parent) {
      chain += " -> " + at;
      if (at == component.name) {
        parent->fail("components ride on each other: " + chain);
      }
      circle = !passed.insert(at).second;
      if (circle) break;
    }
    if (!circle) ends.insert(passed.begin(), passed.end());
  }
}

}  // namespace

void readComponents(const YamlCursor& list, ReadContext& context) {
  std::vector<std::pair<YamlCursor, std::size_t>> items;  // with their components
  for (const YamlCursor& unnamed : list.items()) {
    const YamlCursor item = context.components.add(unnamed);
    items.emplace_back(item, context.scene.components.size());
    Component component;
    component.name = context.components.names().back();
    std::vector<Component> links;
    readComponent(item, component, links, context);
    context.scene.components.push_back(std::move(component));
    for (Component& link : links) {
      context.components.declare(item, link.name);
      context.scene.components.push_back(std::move(link));
    }
  }
  checkParents(items, context);
}

}  // namespace cable_variation
