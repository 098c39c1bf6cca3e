#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/harness/clip.h>

namespace cable_variation {

/// A figure that says whether a harness is good, with its specification limits.
/// Of a measure over several cables or sections, the worst is the value: the
/// smallest distance or bend radius, the largest of everything else.
struct Measure {
  enum class Type {
    distance,         ///< between cables and a component, or other cables; negative: overlap [m]
    similarity,       ///< two-sided Hausdorff distance to the nominal shape, cable by cable [m]
    position,         ///< of a section along a direction [m]
    bend_radius,      ///< smallest of the centreline [m]
    strain,           ///< largest normal strain at the surface [1]
    stress,           ///< largest equivalent stress (von Mises) at the surface [Pa]
    section_force,    ///< [N]
    section_moment,   ///< [N m]
    twist,            ///< between two sections, relative to rest [rad]
    clip_force,       ///< on the cable [N]
    clip_moment,      ///< on the cable [N m]
    slide,            ///< of the cable through a clip: arc length held minus the scene's [m]
    contact_force,    ///< that a component presses a cable with: sum of the amounts of all its forces [N]
    contact_length,   ///< of the stretches along which a cable touches a component [m]
    route_deviation,  ///< two-sided Hausdorff distance of a stretch of a cable to the route planned for it
                      ///< [m]
    energy,           ///< elastic energy of the harness [J]
    eigenvalue        ///< smallest of the Hessian, see EquilibriumSolver [N/m]
  };

  std::string name;
  Type type = Type::distance;
  std::string unit;                      ///< SI
  std::vector<std::size_t> cables;       ///< looked at, indices into Harness::cables
  std::optional<std::size_t> component;  ///< distance, contact_force, contact_length: to this component, of a
                                         ///< robot: to all its links
  std::vector<std::size_t> other_cables;  ///< distance: to these cables
  double skip_near_clips =
      0.0;  ///< distance: sections within this of a clip that rides on `component` do not count [m]
  double skip_near_joints =
      0.0;  ///< distance: pairs of sections whose way through a joint is shorter do not count [m]
  bool surface = false;  ///< similarity: of the cables' surfaces, not of their centrelines
  std::optional<double>
      arc_length;  ///< position, section_force, section_moment: where; else all along the cables [m]
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< position: unit vector, world
  std::optional<Axis>
      axis;  ///< forces and moments: along this axis of the section or clip; else the magnitude
  double from = 0.0, to = 0.0;         ///< twist, route_deviation: arc lengths of the stretch [m]
  std::vector<Eigen::Vector3d> route;  ///< route_deviation: straight from point to point, two at least, no
                                       ///< two neighbours the same [m, world]
  std::string segment;   ///< route_deviation: id of the stretch where its route is from; or empty
  std::size_t clip = 0;  ///< clip_force, clip_moment, slide
  std::optional<double> lower, upper;  ///< specification limits, in `unit`
};

const char* toString(Measure::Type type);  ///< as in a scene file

/// Whether all limits that the measure has are kept. What is not a number keeps none.
bool withinLimits(const Measure& measure, double value);
/// Whether one of them is passed. What is not a number passes none: it is missing, not bad.
bool beyondLimits(const Measure& measure, double value);

}  // namespace cable_variation
