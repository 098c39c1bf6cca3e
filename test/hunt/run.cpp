#include <hunt/run.h>

#include <atomic>
#include <cstdio>
#include <mutex>
#include <thread>

#include <hunt/slenderness.h>

namespace cable_variation::hunt {
namespace {

struct Task {
  std::size_t row;
  std::uint64_t number;
  std::function<Harness()> make;
  bool starts;
};

void judgeAll(const std::vector<Task>& tasks, const HuntOptions& options, std::vector<Tally>& tallies,
              const std::function<void(const Hunted&)>& each) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      const Task& task = tasks[i];
      Hunted hunted;
      hunted.number = task.number;
      hunted.harness = task.make();
      JudgeOptions judge_options = options.judge;
      judge_options.seed = options.seed + task.number;
      if (!task.starts) judge_options.starts = 0;
      hunted.judgement = judge(hunted.harness, judge_options);
      const std::lock_guard<std::mutex> lock(mutex);
      hunted.family = tallies[task.row].name;
      tallies[task.row].add(hunted.judgement);
      each(hunted);
    }
  };
  std::vector<std::thread> threads;
  const unsigned count =
      options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  for (unsigned i = 1; i < count; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
}

}  // namespace

std::vector<Tally> hunt(const HuntOptions& options, const std::function<void(const Hunted&)>& each) {
  std::vector<Task> tasks;
  std::vector<Tally> tallies;
  for (const Family& family : families()) {
    bool wanted = options.only.empty();
    for (const std::string& name : options.only) wanted = wanted || &familyOf(name) == &family;
    if (!wanted) continue;
    const std::size_t count = options.only.empty() ? options.count / family.share : options.count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t number = options.first + i;
      const bool starts = options.starts_every > 0 && i % options.starts_every == 0;
      tasks.push_back({tallies.size(), number,
                       [&family, &options, number] { return makeHarness(family, options.seed, number); },
                       starts});
    }
    tallies.emplace_back();
    tallies.back().name = family.name;
  }
  judgeAll(tasks, options, tallies, each);
  return tallies;
}

std::vector<Tally> huntSlender(std::size_t count, const std::vector<double>& kappas,
                               const HuntOptions& options, const std::function<void(const Hunted&)>& each) {
  constexpr std::size_t kAligned = 11;
  std::vector<Task> tasks;
  std::vector<Tally> tallies;
  for (const Setting setting : {Setting::fixed_ends, Setting::eyelet, Setting::sliding_rolling,
                                Setting::sliding, Setting::free_end, Setting::aligned_clamps}) {
    for (const double kappa : kappas) {
      const bool aligned = setting == Setting::aligned_clamps;
      for (std::size_t i = 0; i < (aligned ? kAligned : count); ++i) {
        const auto make = [setting, kappa, i, aligned, &options] {
          if (aligned) return alignedClamps(kappa, 0.02 + 0.48 * static_cast<double>(i) / (kAligned - 1));
          Draw draw(options.seed, 500 + static_cast<std::uint32_t>(setting), i);
          return slenderHarness(draw, setting, kappa);
        };
        tasks.push_back({tallies.size(), i, make, options.starts_every > 0 && i % options.starts_every == 0});
      }
      char name[64];
      std::snprintf(name, sizeof name, "%s, κ = %.0e", toString(setting), kappa);
      tallies.emplace_back();
      tallies.back().name = name;
    }
  }
  judgeAll(tasks, options, tallies, each);
  return tallies;
}

}  // namespace cable_variation::hunt
