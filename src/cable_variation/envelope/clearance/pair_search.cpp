#include <cable_variation/envelope/clearance/pair_search.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include <tbb/parallel_for.h>

#include <cable_variation/util/counter_random.h>

namespace cable_variation {
namespace {

constexpr std::uint32_t kPairStream = 5;    // of random numbers
constexpr double kDifference = 1e-3;        // of a tolerance, to take slopes by
constexpr double kBend = 1.5;               // of what slopes say, that a distance may change by
constexpr std::size_t kSamplesTried = 256;  // of the envelope in a phase
constexpr std::size_t kStarts = 4;          // the closest of these
constexpr int kMostSteps = 12, kHalvings = 5;
constexpr int kTimes = 8;   // steps over a phase
constexpr int kRounds = 5;  // of random shapes

constexpr double kNone = std::numeric_limits<double>::infinity();

class Search {
 public:
  Search(SampleShapes& shapes, const ExactDistance& distance, const ToleranceSpace& tolerances,
         const PairSearchOptions& options)
      : shapes_(shapes), distance_(distance), tolerances_(tolerances), options_(options) {}

  bool found() const { return best_.has_value(); }
  double best() const { return best_ ? best_->pair.distance : kNone; }
  SampleDistance take() { return std::move(*best_); }

  // The distance there; infinity without an equilibrium or a pair. Keeps the smallest.
  double at(const EnvelopeSample& sample) {
    if (options_.check) options_.check();
    const auto solved = shapes_.fresh(sample);
    if (!solved->equilibrium.converged()) return kNone;
    const auto pair = distance_(*solved);
    if (!pair) return kNone;
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto earlier = [&] {
      return std::make_pair(sample.time, sum(sample)) < std::make_pair(best_->time, best_sum_);
    };
    if (!best_ || pair->distance < best_->pair.distance ||
        (pair->distance == best_->pair.distance && earlier())) {
      best_ = SampleDistance{sample.time, sample.deviations, solved, *pair};
      best_sum_ = sum(sample);
    }
    return pair->distance;
  }

  EnvelopeSample design(std::size_t phase, double time) const {
    EnvelopeSample sample = shapes_.envelope().samples[shapes_.designSample(phase)];
    sample.time = time;
    return sample;
  }

  // By how much the distance may get smaller in the phase, to first order and some more.
  double reach(std::size_t phase) {
    const EnvelopePhase& of = shapes_.envelope().phases[phase];
    const EnvelopeSample reference = shapes_.envelope().samples[shapes_.designSample(phase)];
    const double here = at(reference);
    if (here == kNone) return kNone;
    double reach = 0.0;
    for (const double time : {of.start, of.end}) {
      if (time == reference.time) continue;
      const double there = at(design(phase, time));
      if (there != kNone) reach = std::max(reach, std::abs(there - here));
    }
    const Eigen::VectorXd slopes = slopesAt(reference, here);
    for (Eigen::Index i = 0; i < slopes.size(); ++i)
      reach += std::abs(slopes[i]) * std::max(-tolerances_.lower()[i], tolerances_.upper()[i]);
    return kBend * reach;
  }

  void search(std::size_t phase) {
    const Envelope& envelope = shapes_.envelope();
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < envelope.samples.size(); ++i) {
      if (envelope.samples[i].phase == phase) own.push_back(i);
    }
    const std::size_t step = std::max<std::size_t>(1, own.size() / kSamplesTried);
    std::vector<std::pair<double, std::size_t>> starts((own.size() + step - 1) / step);
    tbb::parallel_for(std::size_t{0}, starts.size(), [&](std::size_t i) {
      starts[i] = {at(envelope.samples[own[i * step]]), own[i * step]};
    });
    std::sort(starts.begin(), starts.end());
    tbb::parallel_for(std::size_t{0}, std::min(kStarts, starts.size()), [&](std::size_t i) {
      if (starts[i].first != kNone) descend(envelope.samples[starts[i].second], starts[i].first);
    });
    descend(envelope.samples[shapes_.designSample(phase)], starts.front().first);
  }

  // To where slopes lead, as far as the tolerances go or the distance gets smaller; then to the best time.
  void descend(EnvelopeSample from, double here) {
    for (int step = 0; step < kMostSteps; ++step) {
      const double before = here;
      if (tolerances_.size() > 0) {
        const Eigen::VectorXd slopes = slopesAt(from, here);
        EnvelopeSample to = from;
        to.deviations = tolerances_.farthest(-slopes, from.deviations);
        for (int halving = 0; halving <= kHalvings; ++halving) {
          const double there = at(to);
          if (there < here) {
            here = there;
            from = to;
            break;
          }
          to.deviations = 0.5 * (to.deviations + from.deviations);
        }
      }
      const EnvelopePhase& of = shapes_.envelope().phases[from.phase];
      double aside = (of.end - of.start) / kTimes;
      for (int halving = 0; aside > 0.0 && halving <= kHalvings; ++halving, aside *= 0.5) {
        const double middle = from.time;
        const int steps = halving == 0 ? kTimes : 1;
        for (int k = -steps; k <= steps; ++k) {
          EnvelopeSample to = from;
          to.time = std::clamp(middle + k * aside, of.start, of.end);
          if (to.time == middle) continue;
          const double there = at(to);
          if (there >= here) continue;
          here = there;
          from = to;
        }
      }
      if (here > before - 0.1 * options_.tolerance) return;
    }
  }

  // By how much the closest of the random shapes is closer than the best before.
  double look(std::uint64_t first, const std::vector<double>& phase_bounds, EnvelopeSample& closest) {
    const std::vector<EnvelopePhase>& phases = shapes_.envelope().phases;
    const CounterRandom random(options_.seed, kPairStream);
    const double before = best();
    std::vector<EnvelopeSample> drawn(options_.shapes);
    std::vector<double> found(options_.shapes, kNone);
    tbb::parallel_for(std::size_t{0}, drawn.size(), [&](std::size_t i) {
      RandomRow numbers(random, first + i);
      EnvelopeSample& sample = drawn[i];
      sample.time = phases.front().start + numbers.uniform() * (phases.back().end - phases.front().start);
      while (sample.phase + 1 < phases.size() && sample.time > phases[sample.phase].end) ++sample.phase;
      sample.deviations = i % 2 == 0 ? tolerances_.random(numbers) : tolerances_.randomNearLimits(numbers);
      if (phase_bounds[sample.phase] < before) found[i] = at(sample);
    });
    const auto smallest = std::min_element(found.begin(), found.end());
    if (smallest == found.end() || !(*smallest < before)) return 0.0;
    closest = drawn[static_cast<std::size_t>(smallest - found.begin())];
    return before - *smallest;
  }

 private:
  static double sum(const EnvelopeSample& sample) { return sample.deviations.sum(); }

  // Of the distance by the variables, towards the inside of the tolerances.
  Eigen::VectorXd slopesAt(const EnvelopeSample& sample, double here) {
    Eigen::VectorXd slopes = Eigen::VectorXd::Zero(tolerances_.size());
    tbb::parallel_for(Eigen::Index{0}, slopes.size(), [&](Eigen::Index i) {
      const double width = tolerances_.upper()[i] - tolerances_.lower()[i];
      const double middle = 0.5 * (tolerances_.upper()[i] + tolerances_.lower()[i]);
      const double step = kDifference * (sample.deviations[i] > middle ? -width : width);
      EnvelopeSample aside = sample;
      aside.deviations[i] += step;
      if (!tolerances_.contains(aside.deviations)) aside.deviations[i] = sample.deviations[i] - step;
      const double there = at(aside);
      if (there != kNone && step != 0.0)
        slopes[i] = (there - here) / (aside.deviations[i] - sample.deviations[i]);
    });
    return slopes;
  }

  SampleShapes& shapes_;
  const ExactDistance& distance_;
  const ToleranceSpace& tolerances_;
  const PairSearchOptions& options_;
  std::mutex mutex_;
  std::optional<SampleDistance> best_;
  double best_sum_ = 0.0;
};

}  // namespace

std::optional<ClosestTogether> closestTogether(SampleShapes& shapes, const ExactDistance& distance,
                                               const ToleranceSpace& tolerances,
                                               const std::vector<double>& phase_bounds,
                                               const PairSearchOptions& options) {
  Search search(shapes, distance, tolerances, options);
  std::vector<std::pair<double, std::size_t>> order;  // what may be reached in a phase, and which
  for (std::size_t phase = 0; phase < phase_bounds.size(); ++phase) {
    if (phase_bounds[phase] != kNone) order.emplace_back(phase_bounds[phase], phase);
  }
  // all phases by their designs first: then most need no more
  tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t i) {
    search.at(shapes.envelope().samples[shapes.designSample(order[i].second)]);
  });
  if (!search.found()) return std::nullopt;
  const double of_designs = search.best();
  tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t i) {
    if (order[i].first >= of_designs) return;
    const double here = search.at(shapes.envelope().samples[shapes.designSample(order[i].second)]);
    const double reach = search.reach(order[i].second);
    if (here != kNone && reach != kNone) order[i].first = std::max(order[i].first, here - reach);
  });
  std::sort(order.begin(), order.end());
  for (const auto& [bound, phase] : order) {
    if (bound >= search.best()) break;
    search.search(phase);
  }

  ClosestTogether result;
  result.shapes = options.shapes;
  for (int round = 0; round < kRounds && options.shapes > 0; ++round) {
    EnvelopeSample closest;
    const double before = search.best();
    result.closer = search.look(static_cast<std::uint64_t>(round) * options.shapes, phase_bounds, closest);
    if (result.closer <= options.tolerance) break;
    search.descend(closest, before - result.closer);
  }
  result.closest = search.take();
  return result;
}

}  // namespace cable_variation
