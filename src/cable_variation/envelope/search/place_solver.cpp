#include <cable_variation/envelope/search/place_solver.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <stdexcept>

#include <tbb/parallel_for.h>

#include <cable_variation/equilibrium/batch_solver.h>

namespace cable_variation {
namespace {

// To prepare a phase for batches takes as long as some tens of places; a thread takes so many at a time.
constexpr std::size_t kWorthABatch = 64, kAtATime = 64;

struct Chunk {
  std::size_t phase = 0, first = 0, last = 0;  // of the places in order of their phases
  const BatchSolver* batch = nullptr;          // none: one by one
};

class BatchOfPhase {
 public:
  BatchOfPhase(const ShapeFollower& follower, const BatchSolver& batch)
      : follower_(follower), batch_(batch) {}

  void solve(const std::vector<SamplePlace>& places, const std::size_t* numbers, std::size_t count,
             const std::function<void(std::size_t, const FollowedShape&)>& take) {
    harnesses_.clear();
    taken_.clear();
    const StretchReader& reader = follower_.reader();
    for (std::size_t i = 0; i < count; ++i) {
      try {
        harnesses_.push_back(reader.space().harness(places[numbers[i]]));
        taken_.push_back(numbers[i]);
      } catch (const std::invalid_argument&) {
        take(numbers[i], follower_.follow(places[numbers[i]], false));  // which says why
      }
    }
    if (harnesses_.empty()) return;
    batch_.solve(harnesses_.data(), harnesses_.size());
    for (std::size_t k = 0; k < harnesses_.size(); ++k) {
      const SamplePlace& place = places[taken_[k]];
      FollowedShape followed;
      if (batch_.outcome(k).converged()) {
        followed.equilibrium = batch_.describe(k);
        try {
          followed.shape = reader.read(place, harnesses_[k], followed.equilibrium);
          followed.converged = true;
        } catch (const OtherStations&) {
          // followed below
        }
      }
      if (followed.converged) {
        followed.harness = std::move(harnesses_[k]);
        take(taken_[k], followed);
      } else {
        take(taken_[k], follower_.follow(place, false));
      }
    }
  }

 private:
  const ShapeFollower& follower_;
  BatchSolver batch_;
  std::vector<Harness> harnesses_;
  std::vector<std::size_t> taken_;
};

std::unique_ptr<BatchSolver> batchOf(const PhaseSearch& phase) {
  try {
    return std::make_unique<BatchSolver>(phase.follower().solver());
  } catch (const std::invalid_argument&) {
    return nullptr;  // a clip that slides or the like
  }
}

}  // namespace

std::size_t phaseAt(const std::vector<PhaseSearch>& phases, double time) {
  const auto after = std::find_if(phases.begin(), phases.end(),
                                  [&](const PhaseSearch& phase) { return time <= phase.times().back(); });
  return after == phases.end() ? phases.size() - 1 : static_cast<std::size_t>(after - phases.begin());
}

void solvePlaces(const std::vector<PhaseSearch>& phases, const std::vector<SamplePlace>& places,
                 const ShapeTaker& take) {
  std::vector<std::size_t> phase_of(places.size()), order(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) phase_of[i] = phaseAt(phases, places[i].time);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return phase_of[a] < phase_of[b]; });
  std::vector<std::unique_ptr<BatchSolver>> batches;
  std::vector<Chunk> chunks;
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    const std::size_t phase = phase_of[order[first]];
    while (last < order.size() && phase_of[order[last]] == phase) ++last;
    if (last - first >= kWorthABatch) batches.push_back(batchOf(phases[phase]));
    const BatchSolver* batch = last - first >= kWorthABatch ? batches.back().get() : nullptr;
    for (std::size_t at = first; at < last; at += kAtATime)
      chunks.push_back({phase, at, std::min(at + kAtATime, last), batch});
  }
  tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t c) {
    const Chunk& chunk = chunks[c];
    const ShapeFollower& follower = phases[chunk.phase].follower();
    const auto takeOne = [&](std::size_t index, const FollowedShape& followed) {
      take(index, chunk.phase, followed);
    };
    if (chunk.batch == nullptr) {
      for (std::size_t i = chunk.first; i < chunk.last; ++i)
        takeOne(order[i], follower.follow(places[order[i]], false));
      return;
    }
    BatchOfPhase batch(follower, *chunk.batch);
    for (std::size_t i = chunk.first; i < chunk.last; i += BatchSolver::kBatch)
      batch.solve(places, &order[i], std::min(BatchSolver::kBatch, chunk.last - i), takeOne);
  });
}

}  // namespace cable_variation
