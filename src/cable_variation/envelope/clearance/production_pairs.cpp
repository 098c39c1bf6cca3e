#include <cable_variation/envelope/clearance/production_pairs.h>

#include <algorithm>
#include <mutex>

#include <tbb/parallel_for.h>

#include <cable_variation/envelope/statistical_envelope.h>

namespace cable_variation {

std::vector<std::optional<SampleDistance>> closestInProduction(const Scene& scene,
                                                               const EnvelopeOptions& options,
                                                               SampleShapes& shapes,
                                                               const std::vector<ExactDistance>& distances,
                                                               const std::function<void()>& check) {
  std::vector<std::optional<SampleDistance>> closest(distances.size());
  if (distances.empty()) return closest;
  const Envelope& envelope = shapes.envelope();
  const ProductionDraws& draws = envelope.draws;
  EnvelopeOptions own = options;
  own.variables = envelope.variables;
  const Sampler sampler = productionSampler(scene, own, draws.first + draws.count);
  const double time = envelope.samples.at(shapes.designSample(0)).time;
  std::mutex mutex;
  tbb::parallel_for(std::uint64_t{0}, draws.count, [&](std::uint64_t i) {
    if (check) check();
    const std::uint64_t number = draws.first + i;
    if (std::binary_search(draws.outside.begin(), draws.outside.end(), number)) return;
    const SamplePlace place = productionPlace(sampler, number, time);
    const auto solved = shapes.fresh({place.deviations, time});
    if (!solved->equilibrium.converged()) return;
    for (std::size_t k = 0; k < distances.size(); ++k) {
      const auto pair = distances[k](*solved);
      if (!pair) continue;
      const std::lock_guard<std::mutex> lock(mutex);
      if (!closest[k] || pair->distance < closest[k]->pair.distance)
        closest[k] = SampleDistance{time, place.deviations, solved, *pair};
    }
  });
  return closest;
}

}  // namespace cable_variation
