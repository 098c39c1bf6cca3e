#include <cable_variation/envelope/clearance/envelope_clearance.h>

#include <algorithm>
#include <limits>
#include <set>

#include <tbb/parallel_for.h>

#include <cable_variation/envelope/clearance/clearance_samples.h>
#include <cable_variation/envelope/clearance/clearance_spots.h>
#include <cable_variation/envelope/clearance/closest_solved.h>
#include <cable_variation/envelope/clearance/pair_search.h>
#include <cable_variation/envelope/clearance/production_pairs.h>
#include <cable_variation/envelope/sample_follower.h>
#include <cable_variation/geometry/tube_distance/nearest_place.h>
#include <cable_variation/measures/cable_view.h>
#include <cable_variation/measures/open_parts.h>
#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene/moving_components.h>
#include <cable_variation/util/thread_limit.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

// Gains by less than this share of the margin are left, as by the envelope itself.
constexpr double kWorthwhile = 0.4;

// The nominal arc length of the piece's place that is nearest to a point [m, world].
double arcLengthAt(const EnvelopePiece& piece, const SolvedSample& solved, const Vector3d& point) {
  const Centreline line =
      centrelineOf(solved.harness.cables[piece.cable], solved.equilibrium.shapes[piece.cable]);
  const auto found = NearestPlace(line, false).find(point, {line.pieces.size() / 2, 0.5}, 1e-6);
  return std::clamp(line.arcLength(found.place), piece.start, piece.end);
}

// A harness that was solved is closer than the pieces are: overlaps deeper, or sticks out of them.
void takePlaceOf(const SampleDistance& sample, EnvelopeClearance& clearance) {
  const auto line = [&](std::size_t cable) {
    return centrelineOf(sample.solved->harness.cables[cable], sample.solved->equilibrium.shapes[cable]);
  };
  const ClosestPair& pair = sample.pair;
  const Centreline own = line(clearance.cable);
  clearance.distance = pair.distance;
  clearance.time = sample.time;
  clearance.deviations = sample.deviations;
  clearance.on_envelope = pair.on_cable - own.radius(pair.place) * pair.direction;
  clearance.on_other = pair.on_other;
  clearance.arc_length = own.arcLength(pair.place);
  if (!clearance.other) return;
  const Centreline other = line(*clearance.other);
  clearance.on_other += other.radius(*pair.other_place) * pair.direction;
  clearance.other_arc_length = other.arcLength(*pair.other_place);
}

// Two cables are as close as they come in one harness; what bodies say of shapes that never meet is no more
// than a bound.
void judgeTogether(ClearanceSpot& spot, const ToleranceSpace& tolerances, const EnvelopeOptions& options,
                   const ClearanceOptions& clearance_options, SampleShapes& shapes,
                   std::optional<SampleDistance>& worst) {
  PairSearchOptions search;
  search.tolerance = kWorthwhile * options.margin;
  search.shapes = options.verification;
  search.seed = options.seed;
  search.check = clearance_options.check;
  auto found = closestTogether(shapes, spot.exact, tolerances, spot.phase_bounds, search);
  if (!found) return;
  EnvelopeClearance& clearance = spot.clearance;
  clearance.kind = EnvelopeClearance::Kind::together;
  clearance.random_shapes = found->shapes;
  if (!worst || found->closest.pair.distance < worst->pair.distance) worst = std::move(found->closest);
  if (options.conservative) clearance.margin = 2.0 * std::max(search.tolerance, found->closer);
}

// Of a share of production: harnesses drawn from it, and no others. The design itself may be none that is
// made.
void judgeInProduction(ClearanceSpot& spot, const Envelope& envelope,
                       std::optional<SampleDistance>& closest) {
  if (!closest) return;
  EnvelopeClearance& clearance = spot.clearance;
  clearance.kind = EnvelopeClearance::Kind::production;
  clearance.random_shapes = envelope.draws.count - envelope.draws.outside.size();
  clearance.worst_sample = closest->pair.distance;
  takePlaceOf(*closest, clearance);
}

// What samples solved again tell of the spot.
void complete(ClearanceSpot& spot, const ToleranceSpace& tolerances, const EnvelopeOptions& options,
              const ClearanceOptions& clearance_options, SampleShapes& shapes,
              std::optional<SampleDistance> closest) {
  EnvelopeClearance& clearance = spot.clearance;
  const EnvelopeSample& nearest = shapes.envelope().samples[spot.samples.front()];
  const auto solved = shapes.sample(spot.samples.front());
  const Pose frame = poseIn(solved->components, spot.frame);
  clearance.on_envelope = frame * clearance.on_envelope;
  clearance.on_other = frame * clearance.on_other;
  clearance.time = nearest.time;
  clearance.deviations = nearest.deviations;
  clearance.arc_length = 0.5 * (spot.pieces[0]->start + spot.pieces[0]->end);
  if (clearance.other) clearance.other_arc_length = 0.5 * (spot.pieces[1]->start + spot.pieces[1]->end);
  if (solved->equilibrium.converged()) {
    clearance.arc_length = arcLengthAt(*spot.pieces[0], *solved, clearance.on_envelope);
    if (clearance.other) {
      clearance.other_arc_length = arcLengthAt(*spot.pieces[1], *solved, clearance.on_other);
    }
  }

  std::optional<SampleDistance> worst = closestDesign(shapes, spot.exact);
  clearance.nominal = worst ? worst->pair.distance : std::numeric_limits<double>::infinity();
  clearance.nominal_time = worst ? worst->time : 0.0;
  clearance.between_bodies = clearance.distance;
  if (clearance.other && shapes.envelope().probability > 0.0) {
    clearance.worst_sample = std::numeric_limits<double>::infinity();
    judgeInProduction(spot, shapes.envelope(), closest);
    return;
  }
  for (const std::size_t sample : spot.samples) {
    const auto found = distanceOf(shapes, sample, spot.exact);
    if (found && (!worst || found->pair.distance < worst->pair.distance)) worst = found;
  }
  if (closest && (!worst || closest->pair.distance < worst->pair.distance)) worst = std::move(closest);
  if (clearance.other) judgeTogether(spot, tolerances, options, clearance_options, shapes, worst);
  if (worst && worst->pair.side == ClosestPair::Side::undecided) clearance.undecided = true;
  clearance.worst_sample = worst ? worst->pair.distance : std::numeric_limits<double>::infinity();
  if (!worst) return;
  const bool together = clearance.kind == EnvelopeClearance::Kind::together;
  if (together || worst->pair.distance < clearance.distance) takePlaceOf(*worst, clearance);
  if (together) {
    clearance.distance = std::max(clearance.distance - clearance.margin,
                                  std::min(clearance.between_bodies, clearance.distance));
  }
}

}  // namespace

std::string noteOf(const EnvelopeClearance& clearance) {
  if (clearance.undecided) {
    return "it cannot be told whether the cable is inside '" + clearance.component +
           "', which is open there: counted as outside";
  }
  return clearance.openness.isOpen() ? "'" + clearance.component + "' is open" : "";
}

std::vector<std::string> openPartWarnings(const std::vector<EnvelopeClearance>& clearances) {
  std::set<std::string> told;
  std::vector<std::string> warnings;
  for (const EnvelopeClearance& clearance : clearances) {
    if (!clearance.openness.isOpen() || !told.insert(clearance.component).second) continue;
    warnings.push_back(openPartWarning("component '" + clearance.component + "'", clearance.openness));
  }
  return warnings;
}

std::vector<EnvelopeClearance> clearances(const Scene& scene, const Envelope& envelope,
                                          const EnvelopeOptions& options, const ComponentParts& parts,
                                          const SampleSolver& solve,
                                          const ClearanceOptions& clearance_options,
                                          const ClosestSolved* closest) {
  std::vector<EnvelopeClearance> result;
  withThreads(options.threads, [&] {
    ComponentParts all;
    all.prepareAll(scene, parts);
    SampleShapes shapes(envelope, solve);
    const ToleranceSpace tolerances(scene, envelope.variables);
    const SpotFinder finder(scene, envelope, options, all, shapes, clearance_options,
                            closest != nullptr ? &closest->offsets() : nullptr);
    std::vector<ClearanceSpot> spots = finder.find();
    std::set<std::size_t> needed;
    for (const ClearanceSpot& spot : spots) needed.insert(spot.samples.begin(), spot.samples.end());
    for (std::size_t phase = 0; phase < envelope.phases.size(); ++phase) {
      needed.insert(shapes.designSample(phase));
    }
    shapes.prepare({needed.begin(), needed.end()});
    std::vector<std::optional<SampleDistance>> known(spots.size());
    for (std::size_t i = 0; closest != nullptr && i < spots.size(); ++i) {
      const EnvelopeClearance& of = spots[i].clearance;
      known[i] = of.other ? closest->toCable(of.cable, *of.other)
                          : closest->toComponent(of.cable, componentIndex(scene, of.component));
    }
    if (closest == nullptr && envelope.probability > 0.0) {
      std::vector<std::size_t> pairs;
      std::vector<ExactDistance> distances;
      for (std::size_t i = 0; i < spots.size(); ++i) {
        if (!spots[i].clearance.other) continue;
        pairs.push_back(i);
        distances.push_back(spots[i].exact);
      }
      auto found = closestInProduction(scene, options, shapes, distances, clearance_options.check);
      for (std::size_t k = 0; k < pairs.size(); ++k) known[pairs[k]] = std::move(found[k]);
    }
    result.resize(spots.size());
    tbb::parallel_for(std::size_t{0}, spots.size(), [&](std::size_t i) {
      if (clearance_options.check) clearance_options.check();
      complete(spots[i], tolerances, options, clearance_options, shapes, std::move(known[i]));
      result[i] = std::move(spots[i].clearance);
    });
  });
  return result;
}

std::vector<EnvelopeClearance> clearances(const Scene& scene, const Envelope& envelope,
                                          const EnvelopeOptions& options, const ComponentParts& parts,
                                          const EquilibriumSolver& solver,
                                          const ClearanceOptions& clearance_options,
                                          const ClosestSolved* closest) {
  const SampleFollower follower(scene, options, envelope, solver);
  const SampleSolver solve = [&](const EnvelopeSample& sample) { return follower.solve(sample); };
  return clearances(scene, envelope, options, parts, solve, clearance_options, closest);
}

}  // namespace cable_variation
