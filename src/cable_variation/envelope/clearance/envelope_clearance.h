#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/envelope/envelope_generator.h>
#include <cable_variation/measures/component_parts.h>

namespace cable_variation {

/// The closest two places of an envelope and of what it is measured against.
struct EnvelopeClearance {
  std::size_t cable = 0;             ///< of the envelope, index
  std::string component;             ///< that it is measured against; empty: another cable
  std::optional<std::size_t> other;  ///< cable, index
  /// Between the envelope's surface and the other's [m]. Negative: overlap, minus the depth to which the
  /// other enters one piece of the envelope or a piece enters the other (geometry/body_distance.h), or that
  /// of the deepest harness solved: the envelope as a whole may hold the other deeper.
  double distance = 0.0;
  Eigen::Vector3d on_envelope, on_other;  ///< closest points of the surfaces [m], world at `time`
  double arc_length = 0.0;                ///< on the cable, nominal [m]
  double other_arc_length = 0.0;          ///< likewise on the other cable
  double time = 0.0;                      ///< [s], of the sample closest to the place
  Eigen::VectorXd deviations;             ///< of that sample
  double nominal = 0.0;       ///< distance of the nominal cable, over the motion [m]; negative: overlap
  double nominal_time = 0.0;  ///< [s]
  double worst_sample = 0.0;  ///< smallest exact distance among all harnesses solved that the envelope is to
                              ///< hold, see ClosestSolved [m]: what surely can happen; `distance` bounds what
                              ///< can
  /// What `distance` is a figure of.
  enum class Kind {
    bodies,     ///< between convex bodies that hold all shapes, each at any time of a phase: a bound
    together,   ///< of two cables in one and the same harness at one time: the closest that a search down the
                ///< slopes and random shapes have found, less `margin`; between bodies where that is more
    production  ///< likewise, of an envelope of a share of production: the closest of the `random_shapes`
                ///< that were drawn to verify it and are held. At least that share of production keeps this
                ///< distance and is held, with 95 % confidence, if that was shown of the envelope.
  };
  Kind kind = Kind::bodies;
  double margin = 0.0;  ///< twice what the search leaves, or what random shapes show it to have left [m]
  std::size_t random_shapes = 0;  ///< looked at after the search, independent of it, or drawn and held
  double between_bodies = 0.0;    ///< the bound for cables whose shapes may be any of their bodies' [m]
  PartOpenness openness;          ///< of the component
  bool undecided = false;         ///< whether a cable is inside of it where it is open: counted as outside
  std::vector<std::uint32_t> colliding;  ///< triangles of the component's mesh (mergedMesh()) that enter the
                                         ///< envelope
};

struct ClearanceOptions {
  /// Sections of a cable this close to its clips on a component do not count against it [m]. Unset: as the
  /// scene's distance measures of the two have it (of several the smallest), else kNearClips.
  std::optional<double> skip_near_clips;
  /// Pairs of sections of joined cables whose way through the joint is shorter do not count [m]. Unset:
  /// likewise, else four times the sum of the cables' radii.
  std::optional<double> skip_near_joints;
  static constexpr double kNearClips = 0.03;  // a connector's length [m]
  std::function<void()> check;  ///< called now and then, by any thread; may throw, which ends the work
};

/// Components that the envelope must be seen from for its clearances, to be put into
/// EnvelopeOptions::frames: those that a motion or a variable moves, one of those that move together.
std::vector<std::string> clearanceFrames(const Scene& scene, const EnvelopeOptions& options);

/// What to know of a clearance; empty: nothing.
std::string noteOf(const EnvelopeClearance& clearance);
/// One sentence for each component that is open.
std::vector<std::string> openPartWarnings(const std::vector<EnvelopeClearance>& clearances);

class ClosestSolved;

/// Solves the scene again for a sample of the envelope.
using SampleSolver = std::function<SolvedSample(const EnvelopeSample&)>;

/// Of each cable of the envelope to each component that has a mesh, then of each two cables; left out is
/// what wholly lies near clips or joints. A piece of the envelope counts as a whole if a part of it is
/// further from them than is skipped, in any of the harnesses solved; with ClosestSolved::cuts() the pieces
/// end where what is skipped ends. Between cables, harnesses that can be are measured, see Kind;
/// sections near joints are left out to the millimetre, by the way through the joint.
/// @param options as the envelope was made with @param parts prepared before; the rest is prepared
/// @param solver the design's shape to follow
/// @param closest what was solved while the envelope was made; null: only samples near the closest places
/// count Throws std::invalid_argument: a component moves that the envelope is not seen from, skipped lengths
/// that are no lengths; as requireConverged() does: no equilibrium of the design.
std::vector<EnvelopeClearance> clearances(const Scene& scene, const Envelope& envelope,
                                          const EnvelopeOptions& options, const ComponentParts& parts,
                                          const EquilibriumSolver& solver,
                                          const ClearanceOptions& clearance_options = {},
                                          const ClosestSolved* closest = nullptr);
std::vector<EnvelopeClearance> clearances(const Scene& scene, const Envelope& envelope,
                                          const EnvelopeOptions& options, const ComponentParts& parts,
                                          const SampleSolver& solve,
                                          const ClearanceOptions& clearance_options = {},
                                          const ClosestSolved* closest = nullptr);

}  // namespace cable_variation
