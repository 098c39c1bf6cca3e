#include <hunt/descent_sweep.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <thread>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation::hunt {
namespace {

struct Outcome {
  bool solved = false;
  int steps = 0;
  double energy = 0.0;  // [J]
};

std::vector<Outcome> solveAll(const std::vector<Harness>& harnesses, const DescentOptions& descent,
                              const HuntOptions& options) {
  EquilibriumOptions of;
  of.accuracy = options.judge.accuracy;
  of.eigenvalue = false;
  of.descent = descent;
  std::vector<Outcome> outcomes(harnesses.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < harnesses.size(); i = next++) {
      const Equilibrium found = EquilibriumSolver(of).solve(harnesses[i]);
      outcomes[i] = {found.converged(), found.iterations, found.energy.total()};
    }
  };
  std::vector<std::thread> threads;
  const unsigned count =
      options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  for (unsigned i = 1; i < count; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return outcomes;
}

}  // namespace

std::vector<DescentTry> sweepDescent(const HuntOptions& options, std::size_t& total) {
  std::vector<Harness> harnesses;
  for (const Family& family : families()) {
    for (std::size_t i = 0; i < options.count / family.share; ++i)
      harnesses.push_back(makeHarness(family, options.seed, options.first + i));
  }
  total = harnesses.size();
  const std::vector<Outcome> usual = solveAll(harnesses, {}, options);
  std::vector<DescentTry> tries;
  for (const DescentNumber& number : descentNumbers()) {
    for (const double factor : {0.5, 2.0}) {
      DescentOptions descent;
      number.set(descent, factor * number.get(descent));
      DescentTry of{&number, number.get(descent)};
      const std::vector<Outcome> found = solveAll(harnesses, descent, options);
      double steps = 0.0, usual_steps = 0.0;
      for (std::size_t i = 0; i < found.size(); ++i) {
        const Outcome &a = usual[i], &b = found[i];
        of.solved += b.solved ? 1 : 0;
        of.lost += a.solved && !b.solved ? 1 : 0;
        of.gained += !a.solved && b.solved ? 1 : 0;
        if (!a.solved || !b.solved) continue;
        steps += b.steps;
        usual_steps += a.steps;
        const double apart = 1e-4 * (std::abs(a.energy) + std::abs(b.energy));
        of.lower += b.energy < a.energy - apart ? 1 : 0;
        of.higher += b.energy > a.energy + apart ? 1 : 0;
      }
      of.steps = steps / usual_steps;
      tries.push_back(of);
    }
  }
  return tries;
}

std::string tableOf(const std::vector<DescentTry>& tries, std::size_t total) {
  std::string table = "| of " + std::to_string(total) +
                      " harnesses | solved | lost | gained | steps | lower | higher |\n"
                      "|---|---|---|---|---|---|---|\n";
  for (const DescentTry& of : tries) {
    char row[200];
    std::snprintf(row, sizeof row, "| %s %g | %zu | %zu | %zu | %.2f | %zu | %zu |\n", of.number->name,
                  of.value, of.solved, of.lost, of.gained, of.steps, of.lower, of.higher);
    table += row;
  }
  return table;
}

}  // namespace cable_variation::hunt
