#include <cable_variation/tracking/clip_attachment.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <cable_variation/equilibrium/shape_distance.h>
#include <cable_variation/math/so3.h>

namespace cable_variation {
namespace {

constexpr std::size_t kSections = 400;  // of a cable, that the closest one is looked for among
constexpr int kHalvings = 40;           // of the interval that it is in
constexpr std::size_t kPlaces = 101;    // along each cable, where shapes are compared

bool isFree(const ClipFreedom& freedom) { return freedom.kind == ClipFreedom::Kind::free; }

// The clips that close take the sections where they are; sliding ones that stay are where they have slid to.
Harness closedInPlace(const Harness& from, const Equilibrium& before, const Harness& to) {
  Harness harness = to;
  for (std::size_t i = 0; i < to.clips.size(); ++i) {
    Clip& clip = harness.clips[i];
    if (!clip.attached) continue;
    if (!from.clips[i].attached) {
      clip.pose = before.shapes[clip.cable].pose(clip.arc_length);
    } else if (clip.constraint.slides) {
      clip.arc_length = before.clip_reactions[i].arc_length;
    }
  }
  return harness;
}

void tellDistance(const Equilibrium& before, AttachedClips& attached) {
  const ShapeDistance furthest = shapeDistance(before.shapes, attached.followed.equilibrium.shapes, kPlaces);
  attached.distance = furthest.distance;
  attached.cable = furthest.cable;
  attached.arc_length = furthest.arc_length;
}

}  // namespace

AttachmentGap gapAt(const Clip& clip, const CableShape& shape, double arc_length) {
  const Pose in_clip = clip.pose.inverse() * shape.pose(arc_length);
  Eigen::Vector3d offset = in_clip.position, turn = so3::log(in_clip.orientation);
  for (int k = 0; k < 3; ++k) {
    if (isFree(clip.constraint.translation[static_cast<std::size_t>(k)])) offset[k] = 0.0;
    if (isFree(clip.constraint.rotation[static_cast<std::size_t>(k)])) turn[k] = 0.0;
  }
  return {arc_length, offset.norm(), turn.norm()};
}

AttachmentGap closestSection(const Clip& clip, const CableShape& shape, double margin) {
  const double first = shape.points.front().arc_length + margin;
  const double last = shape.points.back().arc_length - margin;
  const auto at = [&](std::size_t i) {
    return first + (last - first) * static_cast<double>(i) / static_cast<double>(kSections);
  };
  AttachmentGap best = gapAt(clip, shape, first);
  std::size_t nearest = 0;
  for (std::size_t i = 1; i <= kSections; ++i) {
    const AttachmentGap gap = gapAt(clip, shape, at(i));
    if (gap.distance >= best.distance) continue;
    best = gap;
    nearest = i;
  }
  double low = at(nearest == 0 ? 0 : nearest - 1), high = at(std::min(nearest + 1, kSections));
  for (int i = 0; i < kHalvings; ++i) {
    const double a = (2.0 * low + high) / 3.0, b = (low + 2.0 * high) / 3.0;
    (gapAt(clip, shape, a).distance < gapAt(clip, shape, b).distance ? high : low) =
        gapAt(clip, shape, a).distance < gapAt(clip, shape, b).distance ? b : a;
  }
  const AttachmentGap refined = gapAt(clip, shape, 0.5 * (low + high));
  return refined.distance < best.distance ? refined : best;
}

AttachedClips followAttachment(EquilibriumSolver& solver, const Harness& from, const Equilibrium& before,
                               const Harness& to) {
  if (!before.converged())
    throw std::invalid_argument("clips: there is no shape that they could take hold of");
  validate(to);
  AttachedClips attached;
  attached.energy_before = before.energy.total();
  const Harness in_place = closedInPlace(from, before, to);
  EquilibriumSolver following = solver;
  Equilibrium rest = following.solveFrom(in_place, before.shapes);
  if (!rest.converged()) {
    attached.followed.equilibrium = std::move(rest);
    return attached;
  }
  attached.energy_released = attached.energy_before - rest.energy.total();
  Harness end = in_place;
  for (std::size_t i = 0; i < end.clips.size(); ++i) end.clips[i].pose = to.clips[i].pose;
  attached.followed = followClips(following, in_place, rest, end);
  ++attached.followed.solves;
  if (!attached.followed.equilibrium.converged()) return attached;
  tellDistance(before, attached);
  solver = std::move(following);
  return attached;
}

}  // namespace cable_variation
