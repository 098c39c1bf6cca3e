// Blocks of samples that are solved elsewhere, come in any order, or were kept: the same bits as without.
#include <cable_variation/simulation/block_exchange.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/simulation/simulation.h>

#include <simulation/solved_design.h>

namespace cable_variation::test {
namespace {

constexpr std::uint64_t kSamples = 1000;  // seven blocks and a part of one

// A rod whose clip turns about y; where its tip is.
Scene turningRod() {
  Scene scene = freeRod(0.2, 2e-3);
  addVariable(scene, "turn", ClipRotation{0, Axis::y}, -0.1, 0.1);
  Measure tip = measure(Measure::Type::position, "tip_z");
  tip.unit = "m";
  tip.arc_length = 0.2;
  tip.direction = Eigen::Vector3d::UnitZ();
  scene.measures.push_back(tip);
  return scene;
}

struct Produced {
  Simulation simulation;
  std::vector<double> numbers;  // of all samples: index, outcome, deviations, values

  bool operator==(const Produced& other) const {
    const SimulationStatistics &mine = simulation.statistics, &theirs = other.simulation.statistics;
    if (numbers != other.numbers || mine.outcomes != theirs.outcomes) return false;
    for (std::size_t i = 0; i < mine.statistics.size(); ++i) {
      const MeasureStatistics &one = mine.statistics[i], &another = theirs.statistics[i];
      if (one.mean != another.mean || one.sigma != another.sigma || one.skewness != another.skewness)
        return false;
    }
    for (std::size_t i = 0; i < simulation.cables.size(); ++i) {
      for (std::size_t s = 0; s < simulation.cables[i].sections.size(); ++s) {
        const SectionVariation& one = simulation.cables[i].sections[s];
        const SectionVariation& another = other.simulation.cables[i].sections[s];
        if (one.mean != another.mean || one.covariance != another.covariance || one.range != another.range)
          return false;
      }
    }
    return mine.contributions.first_order == theirs.contributions.first_order &&
           mine.contributions.slope == theirs.contributions.slope &&
           simulation.solved_again == other.simulation.solved_again &&
           simulation.discretisation_error == other.simulation.discretisation_error;
  }
};

Produced simulate(const Scene& scene, BlockExchange* exchange, std::size_t threads,
                  std::uint64_t samples = kSamples, std::uint64_t first = 0) {
  const SolvedDesign design(scene);
  SimulationOptions options;
  options.variables = {0};
  options.samples = samples;
  options.first_sample = first;
  options.threads = threads;
  Produced run;
  const auto receive = [&](std::uint64_t index, SampleOutcome outcome, const double* deviations,
                           const double* values) {
    run.numbers.insert(run.numbers.end(), {static_cast<double>(index), static_cast<double>(outcome),
                                           deviations[0], values == nullptr ? 0.0 : values[0]});
  };
  run.simulation =
      simulateVariation(scene, design.evaluator(scene), options, design.solver, receive, {}, exchange);
  return run;
}

using Store = std::map<BlockRange, std::string>;

bool sameBlocks(const Store& one, const Store& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const auto& mine, const auto& theirs) {
                      return mine.first.first == theirs.first.first &&
                             mine.first.count == theirs.first.count && mine.second == theirs.second;
                    });
}

// Has some blocks from before, gets others solved elsewhere in an order of its own, and notes all.
class Elsewhere : public BlockExchange {
 public:
  Elsewhere(Store before, Store others, unsigned seed)
      : before_(std::move(before)), others_(std::move(others)), random_(seed) {}

  std::string solvedBefore(const BlockRange& range) override {
    const auto found = before_.find(range);
    return found == before_.end() ? "" : found->second;
  }
  void keep(const BlockRange& range, const std::string& bytes) override {
    EXPECT_EQ(range.first, kept.empty() ? 0 : kept.rbegin()->first.end());
    kept[range] = bytes;
  }
  std::size_t mostElsewhere() const override { return others_.empty() ? 0 : 4; }
  void deal(BlockDealer& dealer) override {
    std::vector<BlockRange> out;
    while (!others_.empty() && !dealer.ended()) {
      BlockRange range;
      const bool dealt = out.size() < 4 && dealer.next(range);
      if (dealt) out.push_back(range);
      if (out.empty()) std::this_thread::yield();
      if (out.empty() || (dealt && random_() % 2 == 0)) continue;
      std::swap(out.back(), out[random_() % out.size()]);
      dealer.deliver(out.back(), others_.at(out.back()));
      out.pop_back();
    }
  }

  Store kept;

 private:
  Store before_, others_;
  std::mt19937 random_;
};

// Solves all blocks of a simulation for another one.
class Helper : public BlockExchange {
 public:
  std::string solvedBefore(const BlockRange& /*range*/) override { return ""; }
  void keep(const BlockRange& /*range*/, const std::string& /*bytes*/) override { FAIL(); }
  bool isHelper() const override { return true; }
  void help(std::size_t /*threads*/, const std::function<BlockSolver()>& make) override {
    const BlockSolver solve = make();
    for (std::uint64_t first = 0; first < kSamples; first += 128) {
      const BlockRange range{first, static_cast<std::size_t>(std::min<std::uint64_t>(128, kSamples - first))};
      solved[range] = solve(range);
    }
  }

  Store solved;
};

TEST(BlockExchange, blocks_solved_elsewhere_and_before_give_the_same_bits) {
  const Scene scene = turningRod();
  const Produced alone = simulate(scene, nullptr, 2);
  Helper helper;
  EXPECT_EQ(simulate(scene, &helper, 1).simulation.statistics.samples, 0u);
  ASSERT_EQ(helper.solved.size(), 8u);
  for (unsigned seed = 0; seed < 6; ++seed) {
    std::mt19937 random(seed);
    Store before;
    for (const auto& [range, bytes] : helper.solved) {
      if (random() % 3 == 0) before[range] = bytes;
    }
    Elsewhere exchange(before, seed % 2 == 0 ? helper.solved : Store(), seed);
    EXPECT_TRUE(simulate(scene, &exchange, 1 + seed % 2) == alone) << seed;
    EXPECT_TRUE(sameBlocks(exchange.kept, helper.solved)) << seed;
  }
}

TEST(BlockExchange, parts_of_a_simulation_have_its_samples) {
  const Scene scene = turningRod();
  const Produced whole = simulate(scene, nullptr, 2);
  const Produced part = simulate(scene, nullptr, 2, 256, 384);
  EXPECT_TRUE(std::equal(part.numbers.begin(), part.numbers.end(), whole.numbers.begin() + 384 * 4));
}

TEST(BlockExchange, what_are_no_bytes_of_a_block_is_refused) {
  const Scene scene = turningRod();
  Helper helper;
  simulate(scene, &helper, 1);
  const auto refuse = [&](const std::string& bytes, const std::string& what) {
    Store wrong = helper.solved;
    wrong.begin()->second = bytes;
    Elsewhere exchange(wrong, {}, 0);
    try {
      simulate(scene, &exchange, 2);
      FAIL() << what;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  const std::string good = helper.solved.begin()->second;
  refuse(good + "x", "bytes more");
  refuse(good.substr(0, good.size() - 1), "bytes are left");
  refuse(helper.solved.rbegin()->second, "expected 128 from 0");
  std::string outcome = good;
  outcome[16] = 9;
  refuse(outcome, "outcome 9");
}

TEST(BlockExchange, what_it_throws_ends_the_simulation) {
  class Full : public Elsewhere {
   public:
    Full() : Elsewhere({}, {}, 0) {}
    void keep(const BlockRange& range, const std::string& /*bytes*/) override {
      if (range.first >= 256) throw std::runtime_error("full");
    }
  };
  const Scene scene = turningRod();
  Full full;
  EXPECT_THROW(simulate(scene, &full, 2), std::runtime_error);
}

}  // namespace
}  // namespace cable_variation::test
