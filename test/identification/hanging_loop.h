#pragma once

#include <string>

#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/number_text.h>

namespace cable_variation::test {

/// What is known of a wire that hangs in a loop between two clamps which point away from each other.
struct Wire {
  double mass_per_length = 0.0174;  ///< [kg/m]
  double EI = 1.2e-4;               ///< to begin with [N m²]
  double across = -0.123;           ///< of the second clamp from the first [m]
};

/// A loop of 1.5 m, y along gravity. Unknowns: EI, density, a uniform rest curvature ("curl"), one that
/// grows along the wire ("set"), the clamps' directions and the second one's place.
inline Scene hangingLoop(const Wire& wire, bool growing_curvature = false) {
  const std::string EI = numberText(wire.EI) + " N m^2";
  const std::string first = growing_curvature ? "-1" : "1";
  return readSceneText(
      "gravity: [0, 9.81, 0]\naccuracy: 0.01 mm\ncables:\n"
      "  - name: wire\n    length: 1.5 m\n"
      "    stiffness: {EA: 1e4 N, GA: 1e4 N, EI: " +
          EI + ", GJ: " + EI + ", mass_per_length: " + numberText(wire.mass_per_length) +
          " kg/m, radius: 2 mm}\n"
          "    rest_shape: {curvature: [{at: start, value: [0, 0, " +
          first +
          "]}, {at: end, value: [0, 0, 1]}]}\n"
          "    via: [[0.05, 0.3, 0], [-0.06, 0.65, 0], [-0.17, 0.3, 0]]\n"
          "clips:\n"
          "  - {name: a, type: fixed, cable: wire, at: start, pose: {position: [0, 0, 0]}}\n"
          "  - {name: b, type: fixed, cable: wire, at: end, pose: {position: [" +
          numberText(wire.across) +
          ", 0, 0]}}\n"
          "design_variables:\n"
          "  - {name: EI, cable: wire, property: EI, tolerance: 50 %}\n"
          "  - {name: density, cable: wire, property: density, tolerance: 50 %}\n"
          "  - {name: curl, cable: wire, property: rest_curvature, tolerance: 5}\n"
          "  - {name: a_rz, clip: a, rotate: z, tolerance: 20 deg}\n"
          "  - {name: b_rz, clip: b, rotate: z, tolerance: 20 deg}\n"
          "  - {name: b_x, clip: b, translate: x, tolerance: 30 mm}\n",
      "hanging loop", [](const std::string&) { return std::string(); });
}

}  // namespace cable_variation::test
