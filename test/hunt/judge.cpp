#include <hunt/judge.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include <hunt/balance_check.h>
#include <hunt/discrete_minimise.h>
#include <hunt/discrete_start.h>

namespace cable_variation::hunt {
namespace {

// More stretch than this no real cable bears.
constexpr double kLargestStretch = 0.05;

// A clip that slid nearer than this share of its cable to whatever is next has slid out of its room.
constexpr double kSmallestRoom = 0.01;

template <class... Parts>
std::string textOf(const Parts&... parts) {
  std::ostringstream text;
  text.precision(4);
  (text << ... << parts);
  return text.str();
}

double wholeLength(const Harness& harness) {
  double length = 0.0;
  for (const Cable& cable : harness.cables) length = std::max(length, cable.length);
  return length;
}

double bendingScale(const Harness& harness) {
  double scale = 0.0;
  for (const Cable& cable : harness.cables) {
    const Section& section = cable.sections.front().section;
    scale = std::max(scale, std::min(section.EI_y, section.EI_z) / cable.length);
  }
  return scale;
}

struct LowestStart {
  std::optional<DiscreteShape> shape;
  DiscreteRod::Energy energy;
  int stable = 0;      ///< of all starts
  int stretched = 0;   ///< ended stable, but stretched beyond what cables bear
  int compressed = 0;  ///< likewise
};

LowestStart simpleStarts(const DiscreteRod& rod, const JudgeOptions& options, int count) {
  LowestStart lowest;
  for (int i = 0; i < count; ++i) {
    Draw draw(options.seed, 1000, static_cast<std::uint64_t>(i));
    // of six: four with the least twist, one each with a turn more and less
    const int turns = i % 6 == 2 ? 1 : i % 6 == 4 ? -1 : 0;
    DiscreteShape shape = simpleStart(rod, draw, i % 2 == 1, turns);
    if (!descend(rod, shape).stable) continue;
    double sign = 0.0;
    if (rod.largestStretch(shape, &sign) > kLargestStretch) {
      ++(sign > 0.0 ? lowest.stretched : lowest.compressed);
      continue;
    }
    if (rod.smallestRoom(shape) < kSmallestRoom) continue;
    ++lowest.stable;
    const DiscreteRod::Energy energy = rod.energy(shape);
    if (lowest.shape && energy.total() >= lowest.energy.total()) continue;
    lowest.shape = std::move(shape);
    lowest.energy = energy;
  }
  return lowest;
}

// A shape of the coarse grid is one of the cable's if a finer one has it too: stable, with about that energy.
bool confirmed(const DiscreteRod& rod, const DiscreteShape& shape) {
  const DiscreteRod finer(rod.harness(), halved(rod.layout()));
  DiscreteShape there = onHalved(rod.layout(), shape);
  if (!settle(finer, there).stable) {
    there = onHalved(rod.layout(), shape);
    if (!descend(finer, there).stable) return false;
  }
  if (finer.largestStretch(there) > kLargestStretch || finer.smallestRoom(there) < kSmallestRoom)
    return false;
  const DiscreteRod::Energy coarse = rod.energy(shape), fine = finer.energy(there);
  const double scale = std::max(coarse.elastic() + coarse.springs, bendingScale(rod.harness()));
  return std::abs(coarse.total() - fine.total()) < 0.1 * scale;
}

// Where sliding clips are: with that as their start, a solver may find it.
std::string slidTo(const DiscreteRod& rod, const DiscreteShape& shape) {
  std::string text;
  for (std::size_t i = 0; i < rod.layout().clip_station.size(); ++i) {
    const std::size_t station = rod.layout().clip_station[i];
    if (!rod.slides(station)) continue;
    text +=
        textOf(", '", rod.harness().clips[i].name, "' at ", 1e3 * shape.stations[station].arc_length, " mm");
  }
  return text;
}

// Not solved: is there a solution after all, and is the reason true?
Judgement judgeFailure(const Harness& harness, const Equilibrium& answer, const JudgeOptions& options) {
  Judgement judgement;
  const DiscreteRod rod(harness, layOut(harness, options.segments));
  const int starts = std::max(6, options.starts);
  const LowestStart found = simpleStarts(rod, options, starts);
  judgement.text = textOf(toString(answer.status), " (", answer.message, "); ", found.stable, " of ", starts,
                          " simple starts end in a stable shape");
  if (found.stable > 0) {
    if (!confirmed(rod, *found.shape)) {
      judgement.verdict = Verdict::not_solvable;
      judgement.undecided = true;
      judgement.text += ", not confirmed on a finer grid";
      return judgement;
    }
    judgement.verdict = Verdict::unsolved;
    judgement.text += textOf(", ", found.energy.total(), " J", slidTo(rod, *found.shape));
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

void checkTwist(const Harness& harness, const Equilibrium& answer, Judgement& judgement) {
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    if (!harness.cables[c].twist || !answer.message.empty()) continue;
    double twist = 0.0;
    const auto& points = answer.shapes[c].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double h = points[i].arc_length - points[i - 1].arc_length;
      twist += 0.5 * h * (points[i].turn.x() + points[i - 1].turn.x());
    }
    // what is well less than a turn off is the turn that was asked for; the rest is writhe
    if (std::abs(twist - *harness.cables[c].twist) < 1.5 * M_PI) continue;
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

// Settled on two grids from the answer: where it is, whether it is a minimum, and what it has for energy.
struct Independent {
  DiscreteRod rod;
  DiscreteShape shape;
  bool near = false;
};

Independent checkAgainstOwn(const Harness& harness, const Equilibrium& answer, const JudgeOptions& options,
                            Judgement& judgement) {
  const DiscreteLayout coarse = layOut(harness, options.segments), fine = halved(coarse);
  Independent own{DiscreteRod(harness, coarse), {}, false};
  const DiscreteRod finer(harness, fine);
  const DiscreteShape reported = startAt(finer, answer);
  own.shape = startAt(own.rod, answer);
  DiscreteShape settled = reported;
  if (!settle(own.rod, own.shape).stationary || !settle(finer, settled).stationary) {
    judgement.undecided = true;
    judgement.text = "the independent rod does not settle";
    return own;
  }
  const double length = wholeLength(harness);
  double off = 0.0, grids = 0.0;
  // second order: the answer is a third of the grids' difference beyond the finer one
  for (std::size_t i = 0; i < fine.pieces.size(); ++i) {
    for (std::size_t k = 0; k < coarse.pieces[i].segments(); ++k) {
      const Eigen::Vector3d on_coarse = own.shape.vertex(coarse.pieces[i], i, k);
      const Eigen::Vector3d on_fine = settled.vertex(fine.pieces[i], i, 2 * k);
      const Eigen::Vector3d beyond = on_fine + (on_fine - on_coarse) / 3.0;
      off = std::max(off, (beyond - reported.vertex(fine.pieces[i], i, 2 * k)).norm());
      grids = std::max(grids, (on_fine - on_coarse).norm());
    }
  }
  if (grids > 0.02 * length) {
    judgement.undecided = true;
    judgement.text = textOf("the independent grids differ by ", 1e3 * grids, " mm");
    return own;
  }
  own.near = true;
  if (off > 2.0 * options.accuracy + 0.3 * grids) {
    judgement.verdict = Verdict::centreline_off;
    judgement.text =
        textOf("centreline ", 1e3 * off, " mm off, the independent grids differ by ", 1e3 * grids, " mm");
    return own;
  }
  const double on_coarse = smallestEigenvalue(own.rod, own.shape),
               on_fine = smallestEigenvalue(finer, settled);
  judgement.eigenvalue_own = on_fine + (on_fine - on_coarse) / 3.0;
  // clear of the grid's own error, of neutral motions, and of what rounding leaves of a slender rod's
  // stiffness
  double slenderness = 0.0;
  for (const Cable& cable : harness.cables) {
    const Section& section = cable.sections.front().section;
    slenderness = std::max(slenderness,
                           section.EA * cable.length * cable.length / std::min(section.EI_y, section.EI_z));
  }
  const double count = static_cast<double>(options.segments);
  const double unit = bendingScale(harness) / (length * length);
  const double unclear = (1e-3 + 1e-15 * slenderness * count * count) * unit;
  if (on_fine < -unclear && judgement.eigenvalue_own < -unclear &&
      std::abs(on_fine - on_coarse) < 0.5 * std::abs(on_fine)) {
    judgement.verdict = Verdict::saddle;
    judgement.text = textOf("smallest eigenvalue ", on_fine, " N/m (on half the grid ", on_coarse,
                            "), reported ", answer.smallest_eigenvalue);
  }
  return own;
}

void checkLowest(const Harness& harness, const Independent& own, const JudgeOptions& options,
                 Judgement& judgement) {
  const bool hinted = std::any_of(harness.cables.begin(), harness.cables.end(),
                                  [](const Cable& cable) { return cable.twist || !cable.via.empty(); });
  if (hinted || options.starts == 0) return;
  judgement.started = true;
  const LowestStart found = simpleStarts(own.rod, options, options.starts);
  if (!found.shape) return;
  const DiscreteRod::Energy here = own.rod.energy(own.shape);
  const double lower = here.total() - found.energy.total();
  const double distance = largestDistance(*found.shape, own.shape);
  const double scale = std::max(here.elastic() + here.springs, bendingScale(harness));
  if (lower < 0.01 * scale || distance < 0.01 * wholeLength(harness)) return;
  judgement.verdict = Verdict::lower_missed;
  judgement.text = textOf("energy ", here.total(), " J, a simple start leads to ", found.energy.total(),
                          " J, ", 1e3 * distance, " mm away");
}

void refuse(Verdict verdict, const Violation& violation, Judgement& judgement) {
  if (violation.times <= 1.0 || judgement.verdict != Verdict::right) return;
  judgement.verdict = verdict;
  judgement.text = textOf(violation.what, ": ", violation.times, " times what is allowed");
}

}  // namespace

const char* toString(Verdict verdict) {
  constexpr const char* kNames[kVerdicts] = {"right",          "equations violated", "balance violated",
                                             "holds violated", "centreline off",     "saddle",
                                             "twist lost",     "alternative lower",  "lower missed",
                                             "unsolved",       "wrong reason",       "not solvable",
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
  const double solve_time = judgement.solve_time;
  Independent own = checkAgainstOwn(harness, answer, options, judgement);
  if (judgement.undecided || judgement.verdict != Verdict::right) {
    // before anything is said against an answer, a finer grid is asked
    JudgeOptions finer = options;
    finer.segments *= 4;
    judgement = Judgement();
    judgement.solve_time = solve_time;
    own = checkAgainstOwn(harness, answer, finer, judgement);
  }
  if (judgement.verdict != Verdict::right) return judgement;
  checkTwist(harness, answer, judgement);
  if (judgement.verdict == Verdict::right) checkAlternatives(answer, harness, judgement);
  if (judgement.verdict == Verdict::right && own.near) checkLowest(harness, own, options, judgement);
  return judgement;
}

}  // namespace cable_variation::hunt
