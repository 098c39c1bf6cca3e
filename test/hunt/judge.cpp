#include <hunt/judge.h>

#include <algorithm>
#include <cmath>

#include <hunt/balance_check.h>
#include <hunt/scales.h>
#include <hunt/settled_check.h>
#include <hunt/simple_starts.h>

namespace cable_variation::hunt {
namespace {

// Not solved: is there a solution after all, and is the reason true?
Judgement judgeFailure(const Harness& harness, const Equilibrium& answer, const JudgeOptions& options) {
  Judgement judgement;
  const DiscreteRod rod(harness, layOut(harness, options.segments));
  const int starts = std::max(6, options.starts);
  const StartsResult found = trySimpleStarts(rod, starts, options.seed);
  judgement.text = textOf(toString(answer.status), " (", answer.message, "); ", found.stable, " of ", starts,
                          " simple starts end in a stable shape");
  if (found.stable > 0) {
    if (!isConfirmed(rod, *found.lowest)) {
      judgement.verdict = Verdict::not_solvable;
      judgement.undecided = true;
      judgement.text += ", not confirmed on a finer grid";
      return judgement;
    }
    judgement.verdict = Verdict::unsolved;
    judgement.text += textOf(", ", found.energy.total(), " J", slidTo(rod, *found.lowest));
    return judgement;
  }
  judgement.verdict = Verdict::not_solvable;
  if (answer.status != EquilibriumStatus::impossible) return judgement;
  judgement.text += textOf("; ", found.stretched, " overstretched, ", found.compressed, " overcompressed");
  const auto says = [&answer](const char* word) { return answer.message.find(word) != std::string::npos; };
  const bool says_compressed = says("compress") || says("pressed") || says("too close");
  if ((says_compressed && found.stretched > 0 && found.compressed == 0) ||
      (!says_compressed && found.compressed > 0 && found.stretched == 0)) {
    judgement.verdict = Verdict::wrong_reason;
  }
  return judgement;
}

// Before anything is said against an answer, a finer grid is asked.
Settled checkSettled(const Harness& harness, const Equilibrium& answer, const JudgeOptions& options,
                     Judgement& judgement) {
  const auto good = [&](const Settled& own) {
    return own.decided && !own.centrelineIsOff(options.accuracy) && !own.isSaddle() &&
           !own.eigenvalueIsOff(answer.smallest_eigenvalue);
  };
  Settled own = settleFrom(harness, answer, options.segments);
  if (!good(own)) own = settleFrom(harness, answer, 4 * options.segments);
  judgement.undecided = !own.decided;
  judgement.text = own.text;
  if (own.isSaddle()) {
    judgement.verdict = Verdict::saddle;
    judgement.text = textOf("smallest eigenvalue ", own.eigenvalue, " N/m (on the coarser grid ",
                            own.eigenvalue_coarse, "), reported ", answer.smallest_eigenvalue);
  } else if (own.centrelineIsOff(options.accuracy)) {
    judgement.verdict = Verdict::centreline_off;
    judgement.text = textOf("centreline ", 1e3 * own.off, " mm off, the independent grids differ by ",
                            1e3 * own.grids, " mm");
  } else if (own.eigenvalueIsOff(answer.smallest_eigenvalue)) {
    judgement.verdict = Verdict::eigenvalue_off;
    judgement.text = textOf("smallest eigenvalue ", own.eigenvalue, " N/m (on the coarser grid ",
                            own.eigenvalue_coarse, "), reported ", answer.smallest_eigenvalue);
  }
  return own;
}

void checkTwist(const Harness& harness, const Equilibrium& answer, Judgement& judgement) {
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    if (!harness.cables[c].twist || !answer.message.empty()) continue;
    double twist = 0.0;
    const auto& points = answer.shapes[c].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double h = points[i].arc_length - points[i - 1].arc_length;
      twist += 0.5 * h * (points[i].darboux.x() + points[i - 1].darboux.x());
    }
    // what is well less than a turn off is the turn that was asked for; the rest is writhe
    if (std::abs(twist - *harness.cables[c].twist) < 1.5 * M_PI) continue;
    const bool said = std::any_of(answer.notes.begin(), answer.notes.end(), [&](const std::string& note) {
      return note.find("'" + harness.cables[c].name + "'") != std::string::npos;
    });
    if (said) continue;
    judgement.verdict = Verdict::twist_lost;
    judgement.text =
        textOf("twist ", twist, " instead of ", *harness.cables[c].twist, " rad, and nothing said so");
  }
}

void checkAlternatives(const Equilibrium& answer, const Harness& harness, Judgement& judgement) {
  const double scale = std::max(bendingScale(harness), std::abs(answer.energy.elastic));
  for (const Alternative& alternative : answer.alternatives) {
    if (alternative.energy >= answer.energy.total() - 1e-6 * scale) continue;
    judgement.verdict = Verdict::alternative_lower;
    judgement.text =
        textOf("alternative of ", alternative.energy, " J is lower than ", answer.energy.total(), " J");
  }
}

void checkLowest(const Harness& harness, const Settled& own, const JudgeOptions& options,
                 Judgement& judgement) {
  const bool hinted = std::any_of(harness.cables.begin(), harness.cables.end(),
                                  [](const Cable& cable) { return cable.twist || !cable.via.empty(); });
  if (hinted || options.starts == 0) return;
  judgement.started = true;
  const StartsResult found = trySimpleStarts(own.rod, options.starts, options.seed);
  if (!found.lowest) return;
  const DiscreteRod::Energy here = own.rod.energy(own.shape);
  const double lower = here.total() - found.energy.total();
  const double distance = largestDistance(*found.lowest, own.shape);
  const double scale = std::max(here.elastic() + here.springs, bendingScale(harness));
  if (lower < 0.01 * scale || distance < 0.01 * longestLength(harness)) return;
  judgement.verdict = Verdict::lower_missed;
  judgement.text = textOf("energy ", here.total(), " J, a simple start leads to ", found.energy.total(),
                          " J, ", 1e3 * distance, " mm away", slidTo(own.rod, *found.lowest));
}

void refuse(Verdict verdict, const Violation& violation, Judgement& judgement) {
  if (violation.times <= 1.0 || judgement.verdict != Verdict::right) return;
  judgement.verdict = verdict;
  judgement.text = textOf(violation.what, ": ", violation.times, " times what is allowed");
}

}  // namespace

const char* toString(Verdict verdict) {
  constexpr const char* kNames[kVerdicts] = {"right",
                                             "equations violated",
                                             "balance violated",
                                             "holds violated",
                                             "centreline off",
                                             "saddle",
                                             "eigenvalue off",
                                             "twist lost",
                                             "alternative lower",
                                             "lower missed",
                                             "unsolved",
                                             "wrong reason",
                                             "not solvable",
                                             "threw"};
  return kNames[static_cast<int>(verdict)];
}

Judgement judge(const Harness& harness, const JudgeOptions& options) {
  EquilibriumOptions solver_options;
  solver_options.accuracy = options.accuracy;
  EquilibriumSolver solver(solver_options);
  Equilibrium answer;
  try {
    answer = solver.solve(harness);
  } catch (const std::exception& error) {
    Judgement judgement;
    judgement.verdict = Verdict::threw;
    judgement.text = error.what();
    return judgement;
  }
  Judgement judgement;
  if (!answer.converged()) {
    judgement = judgeFailure(harness, answer, options);
    judgement.solve_time = answer.solve_time;
    return judgement;
  }
  judgement.solve_time = answer.solve_time;
  refuse(Verdict::equations_violated, checkEquations(harness, answer, options.accuracy), judgement);
  refuse(Verdict::balance_violated, checkBalance(harness, answer), judgement);
  refuse(Verdict::holds_violated, checkHolds(harness, answer), judgement);
  if (judgement.verdict != Verdict::right) return judgement;
  const Settled own = checkSettled(harness, answer, options, judgement);
  if (judgement.verdict != Verdict::right) return judgement;
  checkTwist(harness, answer, judgement);
  if (judgement.verdict == Verdict::right) checkAlternatives(answer, harness, judgement);
  if (judgement.verdict == Verdict::right && own.decided) checkLowest(harness, own, options, judgement);
  return judgement;
}

}  // namespace cable_variation::hunt
