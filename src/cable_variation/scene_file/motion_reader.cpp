#include <stdexcept>

#include <cable_variation/scene/motion_samples.h>
#include <cable_variation/scene/resource_address.h>
#include <cable_variation/scene/tum_file.h>
#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {
namespace {

void readMotion(const YamlCursor& item, Motion& motion, const ReadContext& context) {
  if (!item.checkKeys({"name", "component", "file", "topic", "frame"})) return;
  motion.line = item.line();
  const std::size_t component = context.components.find(item, "component");
  if (component != NameTable::npos) motion.component = context.components.name(component);
  const auto file = item.require("file");
  if (!file) return;
  motion.file = file->text();
  if (motion.file.empty()) return;

  const std::string extension = extensionOf(motion.file);
  const bool is_bag = isBag(motion.file);
  if (!is_bag && extension != ".tum" && extension != ".txt") {
    file->fail("found '" + motion.file + "'; expected a .tum, .txt or .bag file");
    return;
  }
  for (const char* key : {"topic", "frame"}) {
    if (!is_bag && item.has(key)) item.find(key)->fail("it goes with a bag");
  }
  if (is_bag) {
    motion.topic = item.has("topic") ? item.text("topic") : "/tf";
    motion.frame = item.has("frame") ? item.text("frame") : motion.component;
  }
  try {
    const InputLimits& limits = context.limits;
    motion.path = localPath(motion.file, context.find_package, kAnySize, limits.folders);
    if (!is_bag) readTum(motion.path, motion, limits);
    const std::string note = noteOnReplaced(motion);
    if (!note.empty()) file->warn(note);
  } catch (const std::invalid_argument& error) {
    file->fail(error.what());
  }
}

}  // namespace

void readMotions(const YamlCursor& list, ReadContext& context) {
  readEach(list, context.motions, context.scene.motions,
           [&](const YamlCursor& item, Motion& motion) { readMotion(item, motion, context); });
}

}  // namespace cable_variation
