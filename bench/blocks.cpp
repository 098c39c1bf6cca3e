// Blocks of a simulation as other processes solve them: processor time of each, bytes, and what it takes to
// put them together. Written as JSON for scripts/scaling: blocks [SCENE] [BLOCKS].

#include <ctime>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <cable_variation/report/sample_csv.h>
#include <cable_variation/simulation/simulation.h>

#include "shipped_case.h"

namespace cable_variation::bench {
namespace {

constexpr std::size_t kBlock = 128;

double processorTime() {  // of this thread [s]
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Solves blocks for another process.
class Helper : public BlockExchange {
 public:
  explicit Helper(std::uint64_t samples) : samples_(samples) {}
  std::string solvedBefore(const BlockRange& /*range*/) override { return ""; }
  void keep(const BlockRange& /*range*/, const std::string& /*bytes*/) override {}
  bool isHelper() const override { return true; }
  void help(std::size_t /*threads*/, const std::function<BlockSolver()>& make) override {
    const BlockSolver solve = make();
    for (std::uint64_t first = 0; first < samples_; first += kBlock) {
      const BlockRange range{first, kBlock};
      const double start = processorTime();
      blocks[range] = solve(range);
      times.push_back(processorTime() - start);
    }
  }

  std::map<BlockRange, std::string> blocks;
  std::vector<double> times;  // [s]

 private:
  std::uint64_t samples_;
};

// Has them all; what a block takes between two that are complete is noted.
class Merging : public BlockExchange {
 public:
  explicit Merging(const std::map<BlockRange, std::string>& blocks) : blocks_(blocks) {}
  std::string solvedBefore(const BlockRange& range) override { return blocks_.at(range); }
  void keep(const BlockRange& /*range*/, const std::string& /*bytes*/) override {
    const double now = processorTime();
    if (last_ > 0.0) times.push_back(now - last_);
    last_ = now;
  }

  std::vector<double> times;  // [s]

 private:
  const std::map<BlockRange, std::string>& blocks_;
  double last_ = 0.0;
};

std::string list(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    char one[32];
    std::snprintf(one, sizeof one, "%s%.4g", text.empty() ? "" : ", ", number);
    text += one;
  }
  return "[" + text + "]";
}

int measureBlocks(const std::string& name, std::uint64_t blocks) {
  const Scene scene = shippedCase(name);
  EquilibriumOptions accuracy;
  accuracy.accuracy = scene.accuracy;
  EquilibriumSolver solver(accuracy);
  const Harness harness = harnessAt(scene, {});
  const Equilibrium equilibrium = solver.solve(harness);
  if (!equilibrium.converged()) throw std::runtime_error("not solved: " + equilibrium.message);
  const MeasureEvaluator evaluator(scene, {harness, equilibrium, componentPosesAt(scene, {})});
  SimulationOptions options;
  options.variables.resize(scene.design_variables.size());
  std::iota(options.variables.begin(), options.variables.end(), std::size_t{0});
  options.measures.resize(scene.measures.size());
  std::iota(options.measures.begin(), options.measures.end(), std::size_t{0});
  options.samples = blocks * kBlock;
  options.threads = 1;

  Helper helper(options.samples);
  simulateVariation(scene, evaluator, options, solver, {}, {}, &helper);
  Merging merging(helper.blocks), with_file(helper.blocks);
  simulateVariation(scene, evaluator, options, solver, {}, {}, &merging);
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "cable_variation_blocks.csv";
  SampleCsv file(path, scene, options.variables, options.measures, {});
  const auto write = [&](std::uint64_t index, SampleOutcome outcome, const double* deviations,
                         const double* values) { file.add(index, outcome, deviations, values); };
  simulateVariation(scene, evaluator, options, solver, write, {}, &with_file);
  file.stop();
  std::filesystem::remove(file.partialPath());
  std::printf(
      "{\"scene\": \"%s\", \"samples_per_block\": %zu, \"bytes\": %zu,\n \"block\": %s,\n \"merge\": %s,\n"
      " \"merge_and_csv\": %s}\n",
      name.c_str(), kBlock, helper.blocks.begin()->second.size(), list(helper.times).c_str(),
      list(merging.times).c_str(), list(with_file.times).c_str());
  return 0;
}

}  // namespace
}  // namespace cable_variation::bench

int main(int count, char** words) {
  try {
    return cable_variation::bench::measureBlocks(count > 1 ? words[1] : "harness",
                                                 count > 2 ? std::strtoull(words[2], nullptr, 10) : 200);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "blocks: %s\n", error.what());
    return 1;
  }
}
