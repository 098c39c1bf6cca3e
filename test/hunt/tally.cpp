#include <hunt/tally.h>

#include <cmath>
#include <cstdio>
#include <numeric>

namespace cable_variation::hunt {
namespace {

constexpr Verdict kWrong[] = {Verdict::equations_violated, Verdict::balance_violated, Verdict::holds_violated,
                              Verdict::centreline_off,     Verdict::saddle,           Verdict::eigenvalue_off,
                              Verdict::twist_lost};

std::string row(const Tally& tally) {
  std::string text =
      "| " + tally.name + " | " + std::to_string(tally.all()) + " | " + std::to_string(tally.solved());
  for (Verdict verdict : kWrong) text += " | " + std::to_string(tally.of(verdict));
  for (Verdict verdict : {Verdict::alternative_lower, Verdict::lower_missed, Verdict::unsolved,
                          Verdict::wrong_reason, Verdict::not_solvable}) {
    text += " | " + std::to_string(tally.of(verdict));
  }
  char milliseconds[32];
  std::snprintf(milliseconds, sizeof milliseconds, "%.1f", 1e3 * tally.solve_time / std::max(1, tally.all()));
  return text + " | " + std::to_string(tally.undecided) + " | " + milliseconds + " |\n";
}

}  // namespace

void Tally::add(const Judgement& judgement) {
  ++count[static_cast<std::size_t>(judgement.verdict)];
  if (judgement.undecided) ++undecided;
  if (judgement.started) ++started;
  solve_time += judgement.solve_time;
}

int Tally::all() const { return std::accumulate(count.begin(), count.end(), 0); }

int Tally::solved() const {
  return all() - of(Verdict::unsolved) - of(Verdict::wrong_reason) - of(Verdict::not_solvable) -
         of(Verdict::threw);
}

int Tally::wrong() const {
  int total = of(Verdict::threw);
  for (Verdict verdict : kWrong) total += of(verdict);
  return total;
}

Tally sum(const std::vector<Tally>& tallies) {
  Tally total;
  total.name = "all";
  for (const Tally& tally : tallies) {
    for (std::size_t i = 0; i < total.count.size(); ++i) total.count[i] += tally.count[i];
    total.undecided += tally.undecided;
    total.started += tally.started;
    total.solve_time += tally.solve_time;
  }
  return total;
}

std::vector<std::string> missedTargets(const Tally& all) {
  std::vector<std::string> missed;
  const auto expect = [&missed](const char* what, int count, double most) {
    const int allowed = static_cast<int>(std::ceil(most));
    if (count <= allowed) return;
    missed.push_back(std::string(what) + ": " + std::to_string(count) + ", expected at most " +
                     std::to_string(allowed));
  };
  expect("wrong", all.wrong() + all.of(Verdict::alternative_lower), 0.0);
  expect("wrong reason", all.of(Verdict::wrong_reason), 0.0);
  expect("not converged though solvable", all.of(Verdict::unsolved), 3.0 / 3820.0 * all.all());
  expect("lower missed", all.of(Verdict::lower_missed), 2.0 / 336.0 * all.started);
  return missed;
}

std::string tableOf(const std::vector<Tally>& tallies) {
  std::string text =
      "| family | tried | solved | equations | balance | holds | centreline | saddle | eigenvalue | twist "
      "lost | "
      "alternative lower | lower missed | not converged though solvable | wrong reason | no start solves it "
      "| "
      "undecided | ms |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Tally& tally : tallies) text += row(tally);
  return text + row(sum(tallies));
}

}  // namespace cable_variation::hunt
