#include <cable_variation/scene_file/pose_reader.h>
#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {
namespace {

void readJoint(const YamlCursor& item, Joint& joint, const ReadContext& context) {
  if (!item.checkKeys({"name", "type", "parent", "at", "child", "child_at", "rotation", "axis"})) return;
  joint.type = static_cast<Joint::Type>(item.choice("type", {"fixed", "pivot", "hinge"}));

  const std::size_t parent = context.cables.find(item, "parent");
  const std::size_t child = context.cables.find(item, "child");
  if (const auto at = item.require("at"))
    joint.parent_arc_length = readArcLength(*at, context.cableLength(parent));
  if (const auto at = item.find("child_at"))
    joint.child_arc_length = readArcLength(*at, context.cableLength(child));
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
    if (const auto axis = item.require("axis")) joint.axis = readAxisOrDirection(*axis);
  } else if (item.has("axis")) {
    item.find("axis")->fail("it goes with a hinge");
  }
}

}  // namespace

void readJoints(const YamlCursor& list, ReadContext& context) {
  readEach(list, context.joints, context.scene.harness.joints,
           [&](const YamlCursor& item, Joint& joint) { readJoint(item, joint, context); });
}

}  // namespace cable_variation
