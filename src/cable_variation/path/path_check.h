#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <cable_variation/equilibrium/bend_radius.h>
#include <cable_variation/path/component_path.h>
#include <cable_variation/tracking/shape_event.h>

namespace cable_variation {

/// The cables at one time of a path.
struct PathSample {
  double time = 0.0;    ///< [s]
  double length = 0.0;  ///< that ComponentPath::frame has come, or the component that goes furthest [m]
  bool solved = false;  ///< there is an equilibrium; else the rest but `message` is empty or not a number
  std::string message;  ///< why there is none, for a person
  double smallest_eigenvalue = 0.0;                       ///< [N/m]
  std::vector<MeasureValue> measures;                     ///< one per measure of the scene
  std::vector<Reaction> reactions;                        ///< one per clip; 0 of one that is open
  std::vector<BendRadius> bends;                          ///< one per cable
  std::vector<std::vector<Eigen::Vector3d>> centrelines;  ///< per cable, at equal steps of arc length [m]
};

struct TimedEvent {
  double time = 0.0;    ///< [s]
  double length = 0.0;  ///< PathSample::length there [m]
  ShapeEvent event;
};

/// What happens to the cables along a path.
struct PathCheck {
  std::vector<PathSample> samples;  ///< by time, two at least
  std::vector<TimedEvent> events;   ///< by time
  std::vector<std::string> warnings;
  std::size_t solves = 0;  ///< equilibria that it took
  /// Every sample is solved and keeps all limits, and nothing snaps.
  bool kept = false;
};

/// What is to be followed along a path, and how.
struct PathTask {
  Design design;
  ComponentPoses moved;      ///< components in force that are not where the scene has them, placesOf()
  EquilibriumSolver solver;  ///< with the shape in force, of that
  ComponentPath path;
  bool attachments = false;  ///< clips open and close by Scene::attachments, whose times are the path's
  double step = 5e-3;        ///< pathTimes() [m], above 0
};

/// Equilibria followed along a path: from the shape in force, straight to where the path begins, and along
/// it. A snap is told where it begins, between two samples; all else at the sample where it was seen. After a
/// loss of the equilibrium the last one is where each further sample is tried from.
/// @param evaluator of the design, similarity being that to the shape in force
/// @param goes_on told which share is done, 0 to 1, before each sample; false: cancel
/// Throws std::invalid_argument for more than 20,000 samples, as requireConverged() if the shape in force is
/// no equilibrium, and Cancelled.
PathCheck checkPath(PathTask task, const MeasureEvaluator& evaluator,
                    const std::function<bool(double)>& goes_on = {});

/// A measure's worst value along a path: closest to a limit or furthest beyond; without limits the one that
/// is worse of its kind.
struct PathWorst {
  double worst = 0.0, smallest = 0.0, largest = 0.0;  ///< in its unit; not a number: no sample is solved
  double time = 0.0;                                  ///< of the worst [s]
  bool within = true;                                 ///< of the limits, at all samples that are solved
};
PathWorst worstAlong(const PathCheck& check, const Measure& measure, std::size_t index);

/// The largest that a clip (index) does to its cable along a path, magnitudes; where no sample is solved 0.
struct LargestReaction {
  double force = 0.0, moment = 0.0;            ///< [N], [N m]
  double force_time = 0.0, moment_time = 0.0;  ///< [s]
};
LargestReaction largestReaction(const PathCheck& check, std::size_t clip);

/// How tightly a cable (index) is bent at the most along a path.
struct TightestBend {
  double radius = 0.0;  ///< [m]; infinite: it stays straight; not a number: no sample is solved
  double time = 0.0;    ///< [s]
};
TightestBend tightestBend(const PathCheck& check, std::size_t cable);

}  // namespace cable_variation
