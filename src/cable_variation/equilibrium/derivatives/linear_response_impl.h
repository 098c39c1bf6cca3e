#pragma once  // internal to equilibrium/

// What LinearResponse is made of; for its own sources only.

#include <cable_variation/equilibrium/derivatives/linear_response.h>
#include <cable_variation/equilibrium/discretisation/rod_system_impl.h>

namespace cable_variation {

// Of a batch of elements at the equilibrium, all nodes held: derivatives by the arc lengths of their ends,
// and what a change of the harness does.
struct LinearResponse::ExplicitChange {
  element::ArcLength by_arc_length;
  element::Energy elastic;  // without load
  element::ArcLength elastic_by_arc_length;
  // of the change at hand
  alignas(64) double gradient[element::kDofs][element::kLanes];
  alignas(64) double arc_length_gradient[2][element::kLanes];  // of both ends, by properties alone
  alignas(64) double elastic_energy[element::kLanes];          // by properties alone
};

}  // namespace cable_variation
