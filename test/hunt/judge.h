#pragma once

#include <string>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation::hunt {

/// What an independent check says of an answer, the worst first.
enum class Verdict {
  right,
  equations_violated,  ///< between the reported points
  balance_violated,    ///< at clips, joints, loads or in all
  holds_violated,      ///< a clip or joint does not do what it is
  centreline_off,      ///< the independent rod, settled from the answer, is elsewhere
  saddle,              ///< reported as stable
  eigenvalue_off,      ///< the smallest eigenvalue reported is another
  twist_lost,          ///< a hinted twist is not there, and nothing said so
  alternative_lower,   ///< the answer lists a shape lower than itself
  lower_missed,        ///< a simple start leads clearly lower
  unsolved,            ///< not converged, unstable or impossible, though simple starts end in a stable shape
  wrong_reason,        ///< impossible, but not for the reason given
  not_solvable,        ///< not solved, and no simple start ends in a stable shape either
  threw                ///< solve() threw on a sound harness
};
constexpr int kVerdicts = 14;

const char* toString(Verdict verdict);

struct Judgement {
  Verdict verdict = Verdict::right;
  std::string text;         ///< figures, for a person
  double solve_time = 0.0;  ///< [s]
  bool started = false;     ///< simple starts looked for a lower shape
  /// The independent rod did not settle near the answer, so that equations, balance and holds alone count; or
  /// of what was not solved, a simple start's shape was not confirmed.
  bool undecided = false;
};

struct JudgeOptions {
  double accuracy = 1e-4;     ///< asked of the solver [m]
  int starts = 6;             ///< simple starts; 0: of harnesses that were not solved only, and six
  std::uint64_t seed = 1;     ///< of the starts
  std::size_t segments = 40;  ///< of the independent rod, per cable
};

/// Solves and checks.
Judgement judge(const Harness& harness, const JudgeOptions& options);

}  // namespace cable_variation::hunt
