#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/geometry/body/convex_hull.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// A stretch of a motion that the envelope takes together.
struct EnvelopePhase {
  double start = 0.0, end = 0.0;  ///< [s]
  std::size_t poses = 0;          ///< times looked at within it
  double excess =
      0.0;  ///< what convex pieces over all its poses span beyond them, about [m], see MotionPhase
};

/// A harness within the tolerances that was solved for the envelope.
struct EnvelopeSample {
  Eigen::VectorXd deviations;  ///< per variable, from its value in the design [its unit]
  double time = 0.0;           ///< [s]
  std::size_t phase = 0;       ///< index into Envelope::phases
  std::size_t branch = 0;      ///< 0: the design's own equilibrium followed; others: snapped, see Snap
};

/// A stretch of a cable in one phase and one branch, or in a slice of the way that a snap takes: all its
/// shapes lie within `body`.
struct EnvelopePiece {
  std::size_t cable = 0;          ///< index into Harness::cables
  double start = 0.0, end = 0.0;  ///< nominal arc lengths [m]
  std::size_t phase = 0;
  std::size_t branch = 0;
  RoundedHull body;  ///< hull of centrelines, rounded by the cable's radius and the inflation
  std::vector<std::size_t> vertex_sample;  ///< per vertex of the hull: index into Envelope::samples; of an
                                           ///< added vertex: that of another vertex
};

/// The envelope as seen from one frame. The first is the world; others are components that
/// move, for what the cables keep from them is to be seen from them.
struct EnvelopeFrame {
  std::string component = "world";
  std::vector<EnvelopePiece> pieces;  ///< vertices in this frame
};

/// Where the cables jump from the design's branch of equilibria to another one within the tolerances: of all
/// jumps found between the two, the one nearest to the design.
struct Snap {
  Eigen::VectorXd before, after;  ///< deviations on this and on that side of the jump
  double begins = 0.0;            ///< the share of their tolerances that those are, ToleranceSpace::share()
  double time = 0.0;              ///< [s]
  std::size_t branch = 0;         ///< that it leads to
  std::size_t cable = 0;          ///< that moves most
  double arc_length = 0.0;        ///< where it moves most [m]
  double jump = 0.0;              ///< by how much [m]
  double share = 0.0;             ///< of independent random samples that snapped over: evenly within the
                                  ///< tolerances or, with a probability, as production draws them
  double share_bound = 1.0;       ///< of all, with 95 % confidence, one-sided
};

/// How much the envelope holds of independent random shapes that were drawn after it was finished, inflation
/// included.
struct Containment {
  std::size_t shapes = 0;    ///< looked at
  std::size_t outside = 0;   ///< that stick out by more than 1e-9 m
  double outside_bound = 1;  ///< of the share of such shapes that stick out, with 95 % confidence, one-sided;
                             ///< with a probability those without an equilibrium count as outside
  double largest_excess = 0.0;      ///< that one sticks out by [m]; 0: none does
  double largest_protrusion = 0.0;  ///< likewise before the inflation of every piece [m]
  std::size_t failed = 0;           ///< without an equilibrium: not in the envelope
  // of the shape that sticks out most before inflation:
  Eigen::VectorXd deviations;
  double time = 0.0;        ///< [s]
  std::size_t cable = 0;    ///< index
  double arc_length = 0.0;  ///< [m]
};

/// The harnesses of production that an envelope of a share of it was verified with, by their numbers in the
/// sequence of productionSampler().
struct ProductionDraws {
  std::uint64_t first = 0, count = 0;
  std::vector<std::uint64_t> outside;  ///< of them, that the envelope does not hold, in order
};

/// The envelope's volume beside that of the union of shapes within the tolerances, on one grid of voxels.
struct Tightness {
  double envelope_volume = 0.0;  ///< [m³]
  double shapes_volume = 0.0;    ///< [m³]
  std::size_t shapes = 0;
  double voxel = 0.0;  ///< edge [m]
  double ratio() const { return shapes_volume > 0.0 ? envelope_volume / shapes_volume : 0.0; }
};

/// What cables can take up within their tolerances, over a motion.
struct Envelope {
  double probability = 0.0;             ///< share of production that it is to hold; 0: the worst case
  std::vector<std::size_t> cables;      ///< indices into Harness::cables
  std::vector<std::size_t> variables;   ///< indices into Scene::design_variables
  std::vector<EnvelopePhase> phases;    ///< one of no duration without a motion
  std::vector<EnvelopeSample> samples;  ///< the first of each phase has no deviations
  std::vector<EnvelopeFrame> frames;    ///< the first: world
  std::vector<Snap> snaps;              ///< one per branch but the first
  std::size_t branches = 1;
  std::size_t solves = 0;          ///< equilibria, those for containment and tightness left out
  std::size_t failures = 0;        ///< of them without an equilibrium
  double inflation = 0.0;          ///< in every piece's radius [m]
  double largest_inflation = 0.0;  ///< in that of a piece of rare shapes, the largest [m]; at least inflation
  double motion_excess = 0.0;      ///< the largest of the phases [m]
  double discretisation_error = 0.0;  ///< largest estimate among the samples [m]
  Containment containment;
  ProductionDraws draws;  ///< with a probability
  Tightness tightness;
  std::vector<std::string> warnings;
  double solve_time = 0.0;   ///< for the envelope, random shapes to find what it lacks included [s]
  double verify_time = 0.0;  ///< for containment and tightness [s]
};

}  // namespace cable_variation
