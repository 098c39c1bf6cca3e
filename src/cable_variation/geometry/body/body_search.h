#pragma once  // internal to geometry/

#include <algorithm>
#include <atomic>
#include <limits>
#include <vector>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cable_variation/geometry/body/body_distance.h>

// What the searches for closest bodies have in common; not for other headers.

namespace cable_variation {

constexpr double kAsClose = 1e-12;  // distances that differ less count as the same [m]

/// What may hold the smallest distance, by its index among what is searched.
struct Candidate {
  std::size_t index;
  double key;    ///< the smaller, the sooner it is looked at
  double bound;  ///< its distance is at least this [m]
};

/// The smallest distance of candidates, of those as close the one of the lowest index: the same for any
/// number of threads. `evaluate(index, cutoff)`: none if it finds no distance up to the cutoff [m].
template <typename Evaluate>
std::optional<BodyPair> closestOf(std::vector<Candidate> candidates, const Evaluate& evaluate) {
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.key < b.key || (a.key == b.key && a.index < b.index);
  });
  std::vector<std::optional<BodyPair>> found(candidates.size());
  std::atomic<double> best{std::numeric_limits<double>::infinity()};
  std::atomic<std::size_t> next{0};
  tbb::parallel_for(0, tbb::this_task_arena::max_concurrency(), [&](int) {
    for (std::size_t i; (i = next++) < candidates.size();) {
      const double cutoff = best + kAsClose;
      if (candidates[i].bound > cutoff) continue;
      found[i] = evaluate(candidates[i].index, cutoff);
      if (!found[i]) continue;
      double known = best;
      while (found[i]->distance < known && !best.compare_exchange_weak(known, found[i]->distance)) {
      }
    }
  });
  std::optional<BodyPair> first;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i] || found[i]->distance > best + kAsClose) continue;
    found[i]->body = candidates[i].index;
    if (!first || found[i]->body < first->body) first = found[i];
  }
  return first;
}

}  // namespace cable_variation
