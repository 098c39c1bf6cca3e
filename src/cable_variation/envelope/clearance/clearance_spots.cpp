#include <cable_variation/envelope/clearance/clearance_spots.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include <cable_variation/envelope/clearance/clearance_skips.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/geometry/body/body_distance.h>
#include <cable_variation/measures/cable_view.h>
#include <cable_variation/measures/joint_between.h>
#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene/moving_components.h>
#include <cable_variation/sensitivity/component_variation.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using Spot = ClearanceSpot;

constexpr std::size_t kSamplesTried = 4;  // of the envelope near a place, solved again
constexpr double kSameWay = 1e-9;         // by rounding [m]

// By component: what moves it relative to what it rides on; the component itself or one further down.
// "world": nothing.
std::vector<std::string> anchors(const Scene& scene, const EnvelopeOptions& options) {
  std::set<std::string> movers;
  for (const std::size_t motion : options.motions) movers.insert(scene.motions.at(motion).component);
  for (std::size_t i = 0; i < scene.components.size(); ++i) {
    for (const std::size_t variable : ownVariables(scene, i)) {
      if (std::find(options.variables.begin(), options.variables.end(), variable) != options.variables.end())
        movers.insert(scene.components[i].name);
    }
  }
  std::vector<std::string> anchors;
  for (const Component& component : scene.components) {
    componentPose(scene, component.name);  // refuses parents that are not there or ride on their own child
    std::string at = component.name;
    while (at != "world" && movers.count(at) == 0) at = scene.components[componentIndex(scene, at)].parent;
    anchors.push_back(at);
  }
  return anchors;
}

// Samples whose shapes span the piece near a point, the nearest first.
void addSamplesNear(const EnvelopePiece& piece, const Vector3d& point, std::vector<std::size_t>& samples) {
  const auto& vertices = piece.body.core.surface().vertices;
  std::vector<std::size_t> order(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double to_a = (vertices[a] - point).squaredNorm(), to_b = (vertices[b] - point).squaredNorm();
    return to_a < to_b || (to_a == to_b && a < b);
  });
  std::size_t added = 0;
  for (const std::size_t vertex : order) {
    const std::size_t sample = piece.vertex_sample.at(vertex);
    if (std::find(samples.begin(), samples.end(), sample) != samples.end()) continue;
    samples.push_back(sample);
    if (++added == kSamplesTried) return;
  }
}

// The largest |s - at| of the piece [m].
double furthest(const EnvelopePiece& piece, double at) {
  return std::max(std::abs(piece.start - at), std::abs(piece.end - at));
}

// Where one cable hangs on the other.
std::optional<JoinedAt> joinedAt(const SolvedSample& at, std::size_t cable, std::size_t other, double way) {
  return joinedAlong(at.harness, cable, other, way);
}

// @param phase only its pieces
std::optional<Spot> closestPieces(const EnvelopeFrame& frame, std::size_t cable, std::size_t other,
                                  const std::optional<JoinedAt>& joined, std::size_t phase) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<const EnvelopePiece*>> others;
  for (const EnvelopePiece& piece : frame.pieces) {
    if (piece.cable == other && piece.phase == phase) others[{piece.phase, piece.branch}].push_back(&piece);
  }
  std::vector<BodyCouple> couples;
  std::vector<std::pair<const EnvelopePiece*, const EnvelopePiece*>> pieces;
  for (const EnvelopePiece& piece : frame.pieces) {
    if (piece.cable != cable || piece.phase != phase) continue;
    for (const EnvelopePiece* beside : others[{piece.phase, piece.branch}]) {
      if (joined &&
          furthest(piece, joined->on_cable) + furthest(*beside, joined->on_other) < joined->shortest_way) {
        continue;
      }
      couples.emplace_back(&piece.body, &beside->body);
      pieces.emplace_back(&piece, beside);
    }
  }
  const auto pair = cable_variation::distance(couples);
  if (!pair) return std::nullopt;
  Spot spot;
  spot.frame = frame.component;
  const auto& [first, second] = pieces[pair->body];
  spot.pieces = {first, second};
  spot.clearance.cable = cable;
  spot.clearance.other = other;
  spot.clearance.distance = pair->distance;
  spot.clearance.on_envelope = pair->on_body;
  spot.clearance.on_other = pair->on_other;
  addSamplesNear(*first, pair->on_body, spot.samples);
  addSamplesNear(*second, pair->on_other, spot.samples);
  return spot;
}

}  // namespace

SpotFinder::SpotFinder(const Scene& scene, const Envelope& envelope, const EnvelopeOptions& options,
                       const ComponentParts& parts, SampleShapes& shapes,
                       const ClearanceOptions& clearance_options, const ClipOffsets* offsets)
    : scene_(scene),
      envelope_(envelope),
      parts_(parts),
      options_(clearance_options),
      anchors_(anchors(scene, options)),
      start_(shapes.sample(shapes.designSample(0))),
      offsets_(offsets) {
  requireConverged(start_->equilibrium, "clearances: the design has no equilibrium");
  for (const auto& length : {options_.skip_near_clips, options_.skip_near_joints}) {
    if (length && !(std::isfinite(*length) && *length >= 0.0)) {
      throw std::invalid_argument("clearances: skipped near clips or joints " + std::to_string(*length) +
                                  " m, expected a finite length of at least 0");
    }
  }
  bool any_part = false;
  for (std::size_t i = 0; i < scene.components.size(); ++i) any_part = any_part || parts.find(i) != nullptr;
  if (offsets_ == nullptr && any_part) {
    const SampleSpace space(scene, options);
    own_offsets_.emplace(space, space.designAt(options.from), start_->equilibrium);
    offsets_ = &*own_offsets_;
  }
}

std::vector<Spot> SpotFinder::find() const {
  std::vector<Spot> spots;
  const auto take = [&](std::optional<Spot> spot) {
    if (options_.check) options_.check();
    if (spot) spots.push_back(std::move(*spot));
  };
  for (const std::size_t cable : envelope_.cables) {
    for (std::size_t i = 0; i < scene_.components.size(); ++i) {
      if (parts_.find(i) != nullptr) take(toComponent(cable, i));
    }
  }
  for (std::size_t a = 0; a < envelope_.cables.size(); ++a) {
    for (std::size_t b = a + 1; b < envelope_.cables.size(); ++b) {
      take(toCable(envelope_.cables[a], envelope_.cables[b]));
    }
  }
  return spots;
}

const EnvelopeFrame* SpotFinder::frameOf(const std::string& name) const {
  for (const EnvelopeFrame& frame : envelope_.frames) {
    if (frame.component == name) return &frame;
  }
  return nullptr;
}

// Whether a part of the piece is ever further than `near` from the clips.
bool SpotFinder::counts(const EnvelopePiece& piece, const std::vector<std::size_t>& clips,
                        double near) const {
  return std::none_of(clips.begin(), clips.end(), [&](std::size_t clip) {
    return std::max(offsets_->largest(clip, piece.start), offsets_->largest(clip, piece.end)) <=
           near + kSameWay;
  });
}

std::optional<Spot> SpotFinder::toComponent(std::size_t cable, std::size_t component) const {
  const std::string& name = scene_.components[component].name;
  const EnvelopeFrame* frame = frameOf(anchors_[component] == "world" ? "world" : name);
  if (frame == nullptr) frame = frameOf(anchors_[component]);
  if (frame == nullptr) {
    throw std::invalid_argument("clearances: component '" + name + "' moves with '" + anchors_[component] +
                                "', which the envelope is not seen from");
  }
  const double near = skippedNearClips(scene_, options_, cable, component);
  const std::vector<std::size_t> clips = clipsBetween(scene_, start_->harness, cable, name);
  std::vector<const RoundedHull*> bodies;
  std::vector<const EnvelopePiece*> pieces;
  for (const EnvelopePiece& piece : frame->pieces) {
    if (piece.cable != cable || !counts(piece, clips, near)) continue;
    bodies.push_back(&piece.body);
    pieces.push_back(&piece);
  }
  const DistancePart& part = *parts_.find(component);
  const Pose& of_component = start_->components.at(name);
  const Pose pose = poseIn(start_->components, frame->component).inverse() * of_component;
  const auto pair = cable_variation::distance(bodies, part, pose);
  if (!pair) return std::nullopt;
  Spot spot;
  spot.frame = frame->component;
  spot.pieces = {pieces[pair->body]};
  spot.clearance.cable = cable;
  spot.clearance.component = name;
  spot.clearance.openness = part.openness();
  spot.clearance.undecided = pair->undecided;
  spot.clearance.distance = pair->distance;
  spot.clearance.on_envelope = pair->on_body;
  spot.clearance.on_other = pair->on_other;
  if (pair->distance <= 0.0) spot.clearance.colliding = enteringTriangles(bodies, part, pose);
  addSamplesNear(*spot.pieces[0], pair->on_body, spot.samples);
  spot.exact = [this, cable, name, near, &part](const SolvedSample& at) {
    const Centreline line = centrelineOf(at.harness.cables[cable], at.equilibrium.shapes[cable]);
    return cable_variation::distance(
        line, part, at.components.at(name),
        stretchesNearClips(scene_, at.harness, at.equilibrium, cable, name, near));
  };
  return spot;
}

std::optional<Spot> SpotFinder::toCable(std::size_t cable, std::size_t other) const {
  const auto& shapes = start_->equilibrium.shapes;
  const double way =
      skippedNearJoints(scene_, options_, cable, other, shapes.at(cable).radius + shapes.at(other).radius);
  const auto joined = joinedAt(*start_, cable, other, way);
  std::optional<Spot> best;
  std::vector<double> phase_bounds;
  for (std::size_t phase = 0; phase < envelope_.phases.size(); ++phase) {
    if (options_.check) options_.check();
    // Seen from any frame the distance bounds what can happen: the largest says most.
    std::optional<Spot> of_phase;
    for (const EnvelopeFrame& frame : envelope_.frames) {
      std::optional<Spot> spot = closestPieces(frame, cable, other, joined, phase);
      if (spot && (!of_phase || spot->clearance.distance > of_phase->clearance.distance))
        of_phase = std::move(spot);
    }
    phase_bounds.push_back(of_phase ? of_phase->clearance.distance : std::numeric_limits<double>::infinity());
    if (of_phase && (!best || of_phase->clearance.distance < best->clearance.distance))
      best = std::move(of_phase);
  }
  if (!best) return std::nullopt;
  best->phase_bounds = std::move(phase_bounds);
  best->exact = [cable, other, way](const SolvedSample& at) {
    const auto line = [&](std::size_t of) {
      return centrelineOf(at.harness.cables[of], at.equilibrium.shapes[of]);
    };
    return cable_variation::distance(line(cable), line(other), joinedAt(at, cable, other, way));
  };
  return best;
}

std::vector<std::string> clearanceFrames(const Scene& scene, const EnvelopeOptions& options) {
  std::vector<std::string> frames;
  const std::vector<std::string> of = anchors(scene, options);
  for (std::size_t i = 0; i < of.size(); ++i) {
    const auto& visuals = scene.components[i].visuals;
    const bool seen = std::any_of(visuals.begin(), visuals.end(),
                                  [](const Visual& visual) { return visual.mesh != nullptr; });
    if (seen && of[i] != "world" && std::find(frames.begin(), frames.end(), of[i]) == frames.end()) {
      frames.push_back(of[i]);
    }
  }
  return frames;
}

}  // namespace cable_variation
