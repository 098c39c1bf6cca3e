#include <cable_variation/envelope/clearance/clearance_samples.h>

#include <algorithm>
#include <stdexcept>

#include <tbb/parallel_for.h>

namespace cable_variation {
namespace {

constexpr std::size_t kCloselyLookedAt = 4;  // phases
constexpr int kWithinPhase = 4;              // steps
constexpr int kHalvings = 5;                 // of a step, about the best

}  // namespace

SampleShapes::SampleShapes(const Envelope& envelope, const SampleSolver& solver)
    : envelope_(envelope), solver_(solver), designs_(envelope.phases.size(), envelope.samples.size()) {
  for (std::size_t i = 0; i < envelope.samples.size(); ++i) {
    std::size_t& first = designs_.at(envelope.samples[i].phase);
    first = std::min(first, i);
  }
  for (std::size_t phase = 0; phase < designs_.size(); ++phase) {
    if (designs_[phase] == envelope.samples.size()) {
      throw std::invalid_argument("envelope: phase " + std::to_string(phase) + " has no sample");
    }
  }
}

void SampleShapes::prepare(const std::vector<std::size_t>& samples) {
  tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) { sample(samples[i]); });
}

std::shared_ptr<const SolvedSample> SampleShapes::solved(
    std::map<double, std::shared_ptr<const SolvedSample>>& known, double key, const EnvelopeSample& sample) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
  }
  auto solved = std::make_shared<const SolvedSample>(solver_(sample));
  const std::lock_guard<std::mutex> lock(mutex_);
  return known.emplace(key, std::move(solved)).first->second;
}

std::shared_ptr<const SolvedSample> SampleShapes::sample(std::size_t index) {
  return solved(samples_, static_cast<double>(index), envelope_.samples.at(index));
}

std::shared_ptr<const SolvedSample> SampleShapes::design(std::size_t phase, double time) {
  EnvelopeSample sample = envelope_.samples[designs_.at(phase)];
  if (sample.time == time) return this->sample(designs_[phase]);
  sample.time = time;
  return solved(by_time_, time, sample);
}

std::optional<SampleDistance> distanceOf(SampleShapes& shapes, std::size_t sample,
                                         const ExactDistance& distance) {
  const EnvelopeSample& of = shapes.envelope().samples.at(sample);
  SampleDistance result{of.time, of.deviations, shapes.sample(sample), {}};
  if (!result.solved->equilibrium.converged()) return std::nullopt;
  const auto pair = distance(*result.solved);
  if (!pair) return std::nullopt;
  result.pair = *pair;
  return result;
}

std::optional<SampleDistance> closestDesign(SampleShapes& shapes, const ExactDistance& distance) {
  const Envelope& envelope = shapes.envelope();
  struct AtPhase {
    std::size_t phase;
    double distance;
  };
  std::vector<AtPhase> phases;
  std::optional<SampleDistance> best;
  std::size_t best_phase = 0;
  const auto take = [&](std::size_t phase, std::optional<SampleDistance> found) {
    if (!found || (best && found->pair.distance >= best->pair.distance)) return;
    best = std::move(found);
    best_phase = phase;
  };
  for (std::size_t phase = 0; phase < envelope.phases.size(); ++phase) {
    auto found = distanceOf(shapes, shapes.designSample(phase), distance);
    if (!found) continue;
    phases.push_back({phase, found->pair.distance});
    take(phase, std::move(found));
  }
  std::sort(phases.begin(), phases.end(), [](const AtPhase& a, const AtPhase& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.phase < b.phase);
  });
  const auto lookAt = [&](std::size_t phase, double time) {
    const EnvelopePhase& of = envelope.phases[phase];
    if (time < of.start || time > of.end) return;
    const auto solved = shapes.design(phase, time);
    if (!solved->equilibrium.converged()) return;
    const auto pair = distance(*solved);
    const Eigen::VectorXd& none = envelope.samples[shapes.designSample(phase)].deviations;
    if (pair) take(phase, SampleDistance{time, none, solved, *pair});
  };
  const auto step = [&](std::size_t phase) {
    return (envelope.phases[phase].end - envelope.phases[phase].start) / kWithinPhase;
  };
  for (std::size_t i = 0; i < std::min(phases.size(), kCloselyLookedAt); ++i) {
    const std::size_t phase = phases[i].phase;
    for (int k = 0; step(phase) > 0.0 && k <= kWithinPhase; ++k) {
      lookAt(phase, envelope.phases[phase].start + k * step(phase));
    }
  }
  if (best && step(best_phase) > 0.0) {
    const std::size_t phase = best_phase;
    double aside = 0.5 * step(phase);
    for (int halving = 0; halving < kHalvings; ++halving, aside *= 0.5) {
      const double middle = best->time;
      lookAt(phase, middle - aside);
      lookAt(phase, middle + aside);
    }
  }
  return best;
}

}  // namespace cable_variation
