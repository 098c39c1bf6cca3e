#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {
namespace {

constexpr Range kReach{0.0, 10.0, false};  // [m]

void readAttachment(const YamlCursor& item, AttachmentChange& change, const ReadContext& context) {
  if (!item.checkKeys({"clip", "time", "attached", "reach"})) return;
  const std::size_t clip = context.clips.find(item, "clip");
  const auto attached = item.require("attached");
  change.time = item.number("time", quantity::number, Range::notNegative());
  change.reach = item.number("reach", quantity::length, kReach, change.reach);
  if (clip == NameTable::npos || !attached) return;
  change.clip = clip;
  change.attached = attached->flag();
  if (!isMounted(context.scene.harness.clips[clip])) item.fail("it is a free end, which nothing holds");
}

// The harness with its clips as they are after the changes so far.
void checkHeld(const YamlCursor& item, const std::vector<bool>& attached, const ReadContext& context) {
  Harness harness = context.scene.harness;
  if (!faultsOf(harness).empty()) return;  // told elsewhere
  for (std::size_t i = 0; i < harness.clips.size(); ++i) harness.clips[i].attached = attached[i];
  for (const std::string& fault : faultsOf(harness)) item.fail("from then on " + fault);
}

}  // namespace

void readAttachments(const YamlCursor& list, ReadContext& context) {
  std::vector<bool> attached;
  for (const Clip& clip : context.scene.harness.clips) attached.push_back(clip.attached);
  double before = 0.0;
  std::optional<YamlCursor> last;  // of those at the same time
  for (const YamlCursor& entry : list.items()) {
    const std::size_t number = context.scene.attachments.size() + 1;
    const YamlCursor item = entry.labelled("attachment " + std::to_string(number));
    const std::size_t faults = context.faults.count();
    AttachmentChange change;
    readAttachment(item, change, context);
    context.scene.attachments.push_back(change);
    if (context.faults.count() > faults) continue;
    if (change.time < before) {
      item.fail("its time of " + shortNumber(change.time) + " s is before the " + shortNumber(before) +
                " s of the one above; expected them in order");
    }
    if (last && change.time > before) checkHeld(*last, attached, context);
    before = std::max(before, change.time);
    last.emplace(item);
    if (attached[change.clip] == change.attached) {
      item.fail("clip '" + context.clips.name(change.clip) + "' is " + (change.attached ? "closed" : "open") +
                " already");
    }
    attached[change.clip] = change.attached;
  }
  if (last) checkHeld(*last, attached, context);
}

}  // namespace cable_variation
