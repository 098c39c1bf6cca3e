#pragma once  // internal to report/

#include <string>
#include <utility>
#include <vector>

#include <cable_variation/measures/measure_evaluation.h>

namespace cable_variation {

/// What acts at one place of a cable and how it is bent there.
struct ProfilePoint {
  double arc_length = 0.0;             ///< [m]
  double force = 0.0, axial = 0.0;     ///< magnitude; along the cable, tension positive [N]
  double moment = 0.0, torsion = 0.0;  ///< magnitude; about the cable [N m]
  double curvature = 0.0;              ///< of the centreline [1/m]
};

/// Along one cable of a solved harness, by the balance of forces and the curve between the sections solved.
/// At a clip two points share the arc length: loads jump there. Not of a cable that touches a part.
std::vector<ProfilePoint> cableProfile(const SolvedScene& solved, std::size_t cable);

/// Whether a cable touches a part: then what its sections bear between those solved is not yet known.
bool touchesPart(const Equilibrium& equilibrium, std::size_t cable);

/// Force, moment, curvature and bend radius along a cable, with the limits of measures that look at all of
/// it; each with its caption. Of one that touches a part, without force and moment.
std::vector<std::pair<std::string, std::string>> profileCharts(const Scene& scene, const SolvedScene& solved,
                                                               std::size_t cable);

}  // namespace cable_variation
