#include <cable_variation/envelope/clearance/closest_solved.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>
#include <stdexcept>

#include <cable_variation/envelope/clearance/clearance_skips.h>
#include <cable_variation/envelope/clearance/clip_offsets.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/geometry/tube_distance/part_vicinity.h>
#include <cable_variation/measures/cable_view.h>
#include <cable_variation/measures/joint_between.h>
#include <cable_variation/scene/moving_components.h>
#include <cable_variation/util/chosen_indices.h>

namespace cable_variation {
namespace {

// Triangles further from the design's cable than it keeps clear of the part, and this, are hardly ever needed
// [m].
constexpr double kReach = 0.03;

// Shares of what is skipped near a clip at which pieces end. Where a cable slides it is not known beforehand
// how much of what is skipped in the design stays so: of these the largest that does.
const std::vector<double> kHeld{1.0}, kSliding{1.0, 63.0 / 64, 31.0 / 32, 15.0 / 16, 7.0 / 8, 3.0 / 4};

bool slidesSomewhere(const Harness& harness, std::size_t cable) {
  return std::any_of(harness.clips.begin(), harness.clips.end(), [&](const Clip& clip) {
    return clip.attached && clip.cable == cable && clip.constraint.slides;
  });
}

Box boxOf(const Centreline& line) {
  Box box;
  for (const Centreline::Piece& piece : line.pieces) {
    for (const Eigen::Vector3d& point : piece.curve.controlPoints(0.0, 1.0)) box.add(point);
  }
  return box;
}

double largestRadius(const Centreline& line) {
  double largest = 0.0;
  for (const Centreline::Piece& piece : line.pieces)
    largest = std::max({largest, piece.start_radius, piece.end_radius});
  return largest;
}

}  // namespace

struct ClosestSolved::Impl {
  struct Best {
    std::size_t cable = 0;
    std::optional<std::size_t> component, other;  // either
    double near = 0.0;                            // skipped near clips or joints [m]
    std::optional<PartVicinity> vicinity;
    std::atomic<double> distance{std::numeric_limits<double>::infinity()};
    std::optional<SampleDistance> sample;
  };

  Impl(const Scene& of, const EnvelopeOptions& with, const ComponentParts& known)
      : scene(of), options(with), space(scene, options) {
    parts.prepareAll(scene, known);
  }

  std::optional<ClosestPair> measure(const Best& best, const std::vector<Centreline>& lines,
                                     const std::vector<Box>& boxes, const Harness& harness,
                                     const Equilibrium& equilibrium, const ComponentPoses& components) const {
    const double limit = best.distance;
    if (best.other) {
      const double radii = largestRadius(lines[best.cable]) + largestRadius(lines[*best.other]);
      const double gap = std::sqrt(squaredGap(boxes[best.cable], boxes[*best.other]));
      if (gap > limit + radii) return std::nullopt;
      return distance(lines[best.cable], lines[*best.other],
                      joinedAlong(harness, best.cable, *best.other, best.near));
    }
    const std::string& name = scene.components[*best.component].name;
    DistanceSearch search;
    search.limit = limit;
    if (best.vicinity) search.vicinity = &*best.vicinity;
    return distance(lines[best.cable], *parts.find(*best.component), components.at(name),
                    stretchesNearClips(scene, harness, equilibrium, best.cable, name, best.near), 0.0,
                    search);
  }

  const Scene& scene;
  EnvelopeOptions options;
  SampleSpace space;
  ComponentParts parts;
  std::optional<ClipOffsets> offsets;
  std::vector<MaterialCut> cuts;
  std::deque<Best> all;
  std::mutex mutex;
  std::atomic<std::size_t> taken{0};
};

ClosestSolved::ClosestSolved(const Scene& scene, const EnvelopeOptions& options, const ComponentParts& parts,
                             const EquilibriumSolver& solver, const ClearanceOptions& clearance_options)
    : impl_(std::make_unique<Impl>(scene, options, parts)) {
  const SamplePlace start = impl_->space.designAt(options.from);
  EquilibriumSolver following = solver;
  const Harness harness = impl_->space.harness(start);
  const Equilibrium equilibrium = following.update(harness);
  requireConverged(equilibrium, "clearances: the design has no equilibrium");
  impl_->offsets.emplace(impl_->space, start, equilibrium);
  const ComponentPoses components = impl_->space.components(start);
  const std::vector<std::size_t> cables = allOrChosen(options.cables, scene.harness.cables.size(), "cable");
  for (const std::size_t cable : cables) {
    const Centreline line = centrelineOf(harness.cables[cable], equilibrium.shapes[cable]);
    for (std::size_t i = 0; i < scene.components.size(); ++i) {
      const DistancePart* part = impl_->parts.find(i);
      if (part == nullptr) continue;
      Impl::Best& best = impl_->all.emplace_back();
      best.cable = cable;
      best.component = i;
      best.near = skippedNearClips(scene, clearance_options, cable, i);
      for (const std::size_t clip : clipsBetween(scene, harness, cable, scene.components[i].name)) {
        for (const double share : slidesSomewhere(harness, cable) ? kSliding : kHeld) {
          for (const double place : impl_->offsets->placesWithin(clip, share * best.near))
            impl_->cuts.push_back({cable, place});
        }
      }
      const Pose& pose = components.at(scene.components[i].name);
      const auto pair = distance(line, *part, pose);
      const double clear = pair ? std::max(0.0, pair->distance) : 0.0;
      best.vicinity.emplace(line, *part, pose, clear + kReach);
    }
  }
  for (std::size_t a = 0; a < cables.size(); ++a) {
    for (std::size_t b = a + 1; b < cables.size(); ++b) {
      Impl::Best& best = impl_->all.emplace_back();
      best.cable = cables[a];
      best.other = cables[b];
      best.near =
          skippedNearJoints(scene, clearance_options, cables[a], cables[b],
                            equilibrium.shapes[cables[a]].radius + equilibrium.shapes[cables[b]].radius);
    }
  }
}

ClosestSolved::~ClosestSolved() = default;

void ClosestSolved::take(const SamplePlace& place, const Harness& harness, const Equilibrium& equilibrium) {
  ++impl_->taken;
  impl_->offsets->add(harness, equilibrium);
  std::vector<Centreline> lines(harness.cables.size());
  std::vector<Box> boxes(harness.cables.size());
  for (std::size_t cable = 0; cable < lines.size(); ++cable) {
    lines[cable] = centrelineOf(harness.cables[cable], equilibrium.shapes[cable]);
    boxes[cable] = boxOf(lines[cable]);
  }
  const ComponentPoses components = impl_->space.components(place);
  for (Impl::Best& best : impl_->all) {
    const auto pair = impl_->measure(best, lines, boxes, harness, equilibrium, components);
    if (!pair || pair->distance > best.distance) continue;
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    if (pair->distance >= best.distance) continue;
    best.distance = pair->distance;
    best.sample = SampleDistance{
        place.time, place.deviations,
        std::make_shared<const SolvedSample>(SolvedSample{harness, equilibrium, components}), *pair};
  }
}

SolvedWitness ClosestSolved::witness() {
  return [this](const SamplePlace& place, const Harness& harness, const Equilibrium& equilibrium) {
    take(place, harness, equilibrium);
  };
}

const std::vector<MaterialCut>& ClosestSolved::cuts() const { return impl_->cuts; }

const ClipOffsets& ClosestSolved::offsets() const { return *impl_->offsets; }

std::size_t ClosestSolved::taken() const { return impl_->taken; }

std::optional<SampleDistance> ClosestSolved::toComponent(std::size_t cable, std::size_t component) const {
  for (const Impl::Best& best : impl_->all) {
    if (best.cable == cable && best.component == component) return best.sample;
  }
  return std::nullopt;
}

std::optional<SampleDistance> ClosestSolved::toCable(std::size_t cable, std::size_t other) const {
  for (const Impl::Best& best : impl_->all) {
    if ((best.cable == cable && best.other == other) || (best.cable == other && best.other == cable))
      return best.sample;
  }
  return std::nullopt;
}

}  // namespace cable_variation
