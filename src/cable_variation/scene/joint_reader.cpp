#include <limits>

#include <cable_variation/scene/pose_reader.h>
#include <cable_variation/scene/read_context.h>

namespace cable_variation {
namespace {

double lengthOf(const ReadContext& context, std::size_t cable) {
  return cable == NameTable::npos ? std::numeric_limits<double>::quiet_NaN()
                                  : context.scene.harness.cables[cable].length;
}

Eigen::Vector3d readHingeAxis(const YamlCursor& joint) {
  const auto axis = joint.require("axis");
  if (!axis) return Eigen::Vector3d::UnitZ();
  if (axis->isList()) return readDirection(*axis);
  return Eigen::Vector3d::Unit(static_cast<int>(axis->choice({"x", "y", "z"})));
}

void readJoint(const YamlCursor& item, Joint& joint, const ReadContext& context) {
  if (!item.checkKeys({"name", "type", "parent", "at", "child", "child_at", "rotation", "axis"})) return;
  joint.type = static_cast<Joint::Type>(item.choice("type", {"fixed", "pivot", "hinge"}));

  const std::size_t parent = context.cables.find(item, "parent");
  const std::size_t child = context.cables.find(item, "child");
  if (const auto at = item.require("at"))
    joint.parent_arc_length = readArcLength(*at, lengthOf(context, parent));
  if (const auto at = item.find("child_at"))
    joint.child_arc_length = readArcLength(*at, lengthOf(context, child));
  joint.parent = parent == NameTable::npos ? 0 : parent;
  joint.child = child == NameTable::npos ? 0 : child;
  if (parent == child && parent != NameTable::npos) {
    item.find("child")->fail("it is the parent too; expected another cable");
  }

  if (const auto rotation = item.find("rotation")) {
    if (joint.type == Joint::Type::pivot) rotation->fail("a pivot turns freely; it takes no rotation");
    if (rotation->checkKeys(orientationKeys())) joint.rotation = readOrientation(*rotation);
  }
  if (joint.type == Joint::Type::hinge) {
    joint.axis = readHingeAxis(item);
  } else if (item.has("axis")) {
    item.find("axis")->fail("it goes with a hinge");
  }
}

}  // namespace

void readJoints(const YamlCursor& list, ReadContext& context) {
  for (const YamlCursor& entry : list.items()) {
    const YamlCursor item = context.joints.add(entry);
    Joint joint;
    joint.name = context.joints.names().back();
    readJoint(item, joint, context);
    context.scene.harness.joints.push_back(std::move(joint));
  }
}

}  // namespace cable_variation
