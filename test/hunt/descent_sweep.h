#pragma once

#include <string>
#include <vector>

#include <cable_variation/equilibrium/descent_options.h>
#include <hunt/run.h>

namespace cable_variation::hunt {

/// What random harnesses cost with one of the descent's numbers changed, beside its default.
struct DescentTry {
  const DescentNumber* number;
  double value = 0.0;
  std::size_t solved = 0, lost = 0, gained = 0;  ///< that the default does (not) solve
  std::size_t lower = 0, higher = 0;             ///< of those both solve: the energy, by more than 1e-4 of it
  double steps = 0.0;                            ///< Newton steps of those both solve over the default's
};

/// The harnesses of `options`, solved with every number of DescentOptions at half and at twice its default.
/// `total` is set to how many harnesses they are.
std::vector<DescentTry> sweepDescent(const HuntOptions& options, std::size_t& total);

/// As a table in Markdown.
std::string tableOf(const std::vector<DescentTry>& tries, std::size_t total);

}  // namespace cable_variation::hunt
