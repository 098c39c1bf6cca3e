#include <cable_variation/equilibrium/require_converged.h>

#include <cable_variation/util/error.h>

namespace cable_variation {

void requireConverged(const Equilibrium& equilibrium, const std::string& what) {
  if (equilibrium.converged()) return;
  const std::string text = (what.empty() ? toString(equilibrium.status) : what) + ": " + equilibrium.message;
  switch (equilibrium.status) {
    case EquilibriumStatus::converged:
    case EquilibriumStatus::not_converged:
      throw NotConverged(text);
    case EquilibriumStatus::unstable:
      throw Unstable(text);
    case EquilibriumStatus::impossible:
      throw Impossible(text);
  }
}

}  // namespace cable_variation
