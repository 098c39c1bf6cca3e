#pragma once

#include <optional>
#include <string>
#include <vector>

#include <cable_variation/variation/envelope.h>
#include <cable_variation/variation/envelope_generator.h>
#include <cable_variation/variation/measure_evaluation.h>

namespace cable_variation {

/// The closest two places of an envelope and of what it is measured against.
struct EnvelopeClearance {
  std::size_t cable = 0;             ///< of the envelope, index
  std::string component;             ///< that it is measured against; empty: another cable
  std::optional<std::size_t> other;  ///< cable, index
  double distance = 0.0;  ///< between the envelope's surface and the other's [m]; negative: overlap,
                          ///< minus the depth to which the other enters
  Eigen::Vector3d on_envelope, on_other;  ///< closest points of the surfaces [m], world at `time`
  double arc_length = 0.0;                ///< on the cable, nominal [m]
  double other_arc_length = 0.0;          ///< likewise on the other cable
  double time = 0.0;                      ///< [s], of the sample closest to the place
  Eigen::VectorXd deviations;             ///< of that sample
  double nominal = 0.0;       ///< distance of the nominal cable, over the motion [m]; negative: overlap
  double nominal_time = 0.0;  ///< [s]
  double worst_sample = 0.0;  ///< smallest exact distance among harnesses solved within the tolerances [m]:
                              ///< what surely can happen; `distance` bounds what can
  std::vector<std::uint32_t> colliding;  ///< triangles of the component's mesh (its visuals in order, as
                                         ///< merged for distances) that enter the envelope
};

}  // namespace cable_variation
