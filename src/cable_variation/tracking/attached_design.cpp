#include <cable_variation/tracking/attached_design.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/harness/topology.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

std::string millimetres(double length) { return shortNumber(1e3 * length) + " mm"; }

AttachmentGap takeHold(const AttachmentWish& wish, const Harness& harness, const Equilibrium& equilibrium) {
  constexpr double kMargin = 0.01;  // of the length, that a clip that slides keeps from the ends
  const Clip& clip = harness.clips[wish.clip];
  const CableShape& shape = equilibrium.shapes[clip.cable];
  const double margin = clip.constraint.slides ? kMargin * harness.cables[clip.cable].length : 0.0;
  const AttachmentGap closest = closestSection(clip, shape, margin);
  const bool take_closest = wish.closest || clip.constraint.slides;
  const AttachmentGap gap = take_closest ? closest : gapAt(clip, shape, clip.arc_length);
  if (gap.distance <= wish.reach) return gap;
  std::string text = "clip '" + clip.name + "' cannot take hold of cable '" + shape.cable +
                     "': the section at " + millimetres(gap.arc_length) + " is " + millimetres(gap.distance) +
                     " away, expected at most " + millimetres(wish.reach);
  if (!take_closest) {
    text += "; the closest one, at " + millimetres(closest.arc_length) + ", is " +
            millimetres(closest.distance) + " away";
  }
  throw std::invalid_argument(text);
}

}  // namespace

AttachedDesign withAttachments(Design design, const std::vector<AttachmentWish>& wishes,
                               const Harness& harness, const Equilibrium& equilibrium) {
  AttachedDesign result{std::move(design), {}};
  Harness& edited = result.design.scene.harness;
  for (const AttachmentWish& wish : wishes) {
    const Clip& clip = edited.clips.at(wish.clip);
    if (!isMounted(clip)) {
      throw std::invalid_argument("clip '" + clip.name + "' is a free end: it cannot " +
                                  (wish.attached ? "close" : "open"));
    }
    if (clip.attached == wish.attached) {
      throw std::invalid_argument("clip '" + clip.name + "' is " + (wish.attached ? "closed" : "open") +
                                  " already");
    }
    edited.clips[wish.clip].attached = wish.attached;
    result.gaps.emplace_back();
  }
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    if (!wishes[i].attached) continue;
    result.gaps[i] = takeHold(wishes[i], harness, equilibrium);
    const std::string name = edited.clips[wishes[i].clip].name;
    if (result.gaps[i].arc_length != harness.clips[wishes[i].clip].arc_length)
      setClipArcLength(result.design, name, result.gaps[i].arc_length);
  }
  makeTopology(result.design.scene.harness);
  return result;
}

std::vector<AttachmentWish> scheduledAt(const Scene& scene, const Harness& harness, double time) {
  std::vector<std::optional<AttachmentWish>> last(harness.clips.size());
  for (const AttachmentChange& change : scene.attachments) {
    std::optional<AttachmentWish>& wish = last[change.clip];
    if (change.time <= time) {
      wish = AttachmentWish{change.clip, change.attached, false, change.reach};
    } else if (!wish) {  // before its first change it does the opposite
      wish = AttachmentWish{change.clip, !change.attached, false, change.reach};
    }
  }
  std::vector<AttachmentWish> wishes;
  for (const std::optional<AttachmentWish>& wish : last) {
    if (wish && harness.clips[wish->clip].attached != wish->attached) wishes.push_back(*wish);
  }
  return wishes;
}

}  // namespace cable_variation
