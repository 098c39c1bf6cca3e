#include <cable_variation/math/round_step.h>

#include <cmath>
#include <initializer_list>

namespace cable_variation {

double roundStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace cable_variation
