#pragma once

#include <array>
#include <string>
#include <vector>

#include <hunt/judge.h>

namespace cable_variation::hunt {

/// How the harnesses of one family, or of one row of a table, fared.
struct Tally {
  std::string name;
  std::array<int, kVerdicts> count{};
  int undecided = 0;
  int started = 0;          ///< solved and tried by simple starts for lower shapes
  double solve_time = 0.0;  ///< of all [s]

  void add(const Judgement& judgement);
  int of(Verdict verdict) const { return count[static_cast<std::size_t>(verdict)]; }
  int all() const;
  int solved() const;  ///< answered as converged
  int wrong() const;   ///< answered as converged, and it is not true
};

Tally sum(const std::vector<Tally>& tallies);

/// What is aimed at and missed: nothing wrong and no wrong reason, 3 of 3,820 not solved though solvable, a
/// clearly lower shape missed in 2 of 336; both rounded up.
std::vector<std::string> missedTargets(const Tally& all);

/// As a table in Markdown.
std::string tableOf(const std::vector<Tally>& tallies);

}  // namespace cable_variation::hunt
