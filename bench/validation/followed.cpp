#include "followed.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/equilibrium/require_converged.h>

namespace cable_variation::validation {

double followedTo(const std::function<Harness(double)>& at, double low, double step, double most,
                  double jump) {
  EquilibriumOptions options;
  options.accuracy = 1e-4 * jump;
  EquilibriumSolver solver(options);
  Equilibrium last = solver.solve(at(low));
  requireConverged(last, "the start of a benchmark");
  while (step > 1e-4 * std::abs(low) && low + step < most) {
    EquilibriumSolver next = solver;
    const Equilibrium there = next.update(at(low + step));
    double moved = INFINITY;
    if (there.converged()) {
      moved = 0.0;
      for (int i = 0; i <= 40; ++i) {
        const double s = at(low).cables[0].length * i / 40.0;
        moved = std::max(moved, (there.shapes[0].position(s) - last.shapes[0].position(s)).norm());
      }
    }
    if (moved > jump) {
      step *= 0.5;
      continue;
    }
    low += step;
    solver = std::move(next);
    last = there;
  }
  return low;
}

}  // namespace cable_variation::validation
