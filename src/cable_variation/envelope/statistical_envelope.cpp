#include <cable_variation/envelope/statistical_envelope.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <Eigen/Cholesky>
#include <boost/math/distributions/binomial.hpp>

#include <cable_variation/statistics/confidence.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/number_text.h>

namespace cable_variation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Of the shapes that may be outside, so many are among those verified: then a share a third below it is told
// from it. Likewise among those learnt from.
constexpr double kVerifiedOutside = 15.0, kLearntOutside = 8.0;
constexpr std::size_t kFewest = 2000, kMostLearnt = 4000, kFewestLearnt = 300;
// Ends of stretches kept while learning, some 300 MB.
constexpr std::size_t kMostLearntStretches = 1500000;
// Shapes that stick out by more than this are worth to be taken into the hulls [m].
constexpr double kWorthwhile = 5e-5;
// The first look's probability to err, and what is left of it with each further look.
constexpr double kFirstError = 0.04, kErrorLeft = 0.2;
// The inflation is chosen so that verification succeeds with this probability.
constexpr double kLikely = 0.9;
// Tells production drawn for an envelope from that of a simulation with the same seed.
constexpr std::uint64_t kProduction = 0x9e3779b97f4a7c15;
// An end that does not vary more than this does not vary [m].
constexpr double kStill = 1e-5;

double errorOfLook(int look) { return kFirstError * std::pow(kErrorLeft, look); }

// The most of `shapes` that may stick out for the bound to show the probability; none: not even 0.
std::optional<std::size_t> mostOutside(const StatisticalPlan& plan, int look) {
  const auto shows = [&](std::size_t outside) {
    return shareUpperBound(outside, plan.verification, 1.0 - errorOfLook(look)) <= 1.0 - plan.probability;
  };
  if (!shows(0)) return std::nullopt;
  std::size_t most = 0, more = plan.verification;  // shows(most), but not shows(more)
  while (more - most > 1) {
    const std::size_t middle = most + (more - most) / 2;
    (shows(middle) ? most : more) = middle;
  }
  return most;
}

// Of `known` shapes, how many may stick out of an inflation for it to be likely that no more than `allowed`
// of those verified do.
std::size_t likelyOutside(std::size_t allowed, std::size_t verified, std::size_t known) {
  double low = 0.0, high = 1.0;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (low + high);
    const boost::math::binomial_distribution<> of(static_cast<double>(verified), middle);
    (boost::math::cdf(of, static_cast<double>(allowed)) >= kLikely ? low : high) = middle;
  }
  return static_cast<std::size_t>(low * static_cast<double>(known));
}

// Of `of` shapes learnt from, how many stay out of the hulls: as many as may be outside in the end, so that
// the inflation has next to nothing to make up for, and hulls alone do not hold more than is asked for.
std::size_t leftOut(const StatisticalPlan& plan, std::size_t of) {
  return likelyOutside(mostOutside(plan, 0).value_or(0), plan.verification, of);
}

// How unusual shapes are: the largest Mahalanobis distance of any end from its mean; of one without an
// equilibrium infinity. What an end moves along its cable takes up no other space, but at the cable's ends.
std::vector<double> unusualness(const std::vector<FollowedShape>& shapes,
                                const std::vector<MaterialStretch>& stretches) {
  std::vector<double> largest(shapes.size(), kInfinity);
  std::vector<std::size_t> solved;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!shapes[i].converged) continue;
    largest[i] = 0.0;
    solved.push_back(i);
  }
  if (solved.empty()) return largest;
  const auto count = static_cast<double>(solved.size());
  Eigen::Matrix3Xd mean = Eigen::Matrix3Xd::Zero(3, shapes[solved.front()].shape.ends[0].cols());
  for (const std::size_t i : solved) mean += shapes[i].shape.ends[0] / count;
  for (Eigen::Index end = 0; end < mean.cols(); ++end) {
    const auto stretch = static_cast<std::size_t>(end / 2);
    const std::size_t beside = end % 2 == 0 ? stretch - 1 : stretch + 1;  // wraps around before the first
    const bool last = beside >= stretches.size() || stretches[beside].cable != stretches[stretch].cable;
    Eigen::Matrix3d across = Eigen::Matrix3d::Identity();
    if (!last) {
      const Eigen::Vector3d along = (mean.col(end | 1) - mean.col(end & ~Eigen::Index{1})).normalized();
      across -= along * along.transpose();
    }
    Eigen::Matrix3d covariance = kStill * kStill * Eigen::Matrix3d::Identity();
    for (const std::size_t i : solved) {
      const Eigen::Vector3d off = across * (shapes[i].shape.ends[0].col(end) - mean.col(end));
      covariance += off * off.transpose() / count;
    }
    const Eigen::LLT<Eigen::Matrix3d> factor(covariance);
    for (const std::size_t i : solved) {
      const Eigen::Vector3d off = across * (shapes[i].shape.ends[0].col(end) - mean.col(end));
      largest[i] = std::max(largest[i], factor.matrixL().solve(off).norm());
    }
  }
  return largest;
}

// Puts the most usual shapes into the hulls: those that snapped first, the largest jump before all, for the
// slices are along its way.
void takeUsual(PhaseSearch& search, std::vector<FollowedShape>& shapes, std::size_t left_out) {
  const std::vector<double> unusual = unusualness(shapes, search.follower().reader().stretches());
  std::vector<std::size_t> order(shapes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return unusual[a] < unusual[b]; });
  order.resize(order.size() - std::min(left_out, order.size()));
  const auto jump = [&](std::size_t i) { return shapes[i].jump ? shapes[i].jump->motion().norm() : 0.0; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return jump(a) > jump(b); });
  for (const std::size_t i : order) {
    search.add(shapes[i]);
    shapes[i] = FollowedShape();  // gives its memory back
  }
  search.rebuild();
}

// Takes in shapes that stick out, but for those that stick out most: hulls grow where shapes are, an
// inflation everywhere.
void takeIn(PhaseSearch& search, std::vector<std::pair<double, FollowedShape>>& sticking_out,
            std::size_t left_out) {
  std::stable_sort(sticking_out.begin(), sticking_out.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t i = left_out; i < sticking_out.size(); ++i) search.add(sticking_out[i].second);
  search.rebuild();
}

double protrusionOf(const RandomShape& shape) { return shape.converged ? shape.protrusion : kInfinity; }

// What all but `outside` of the protrusions [m] are at most.
double inflationFor(std::vector<double> protrusions, std::size_t outside) {
  const auto at = protrusions.begin() + static_cast<std::ptrdiff_t>(outside);
  std::nth_element(protrusions.begin(), at, protrusions.end(), std::greater<>());
  return std::max(0.0, *at);
}

}  // namespace

std::uint64_t StatisticalPlan::samples() const {
  return learnt + added + calibration + kMostLooks * verification;
}

StatisticalPlan planFor(double probability, std::size_t verification, std::size_t stretches) {
  if (!(probability > 0.0 && probability < 1.0)) {
    std::ostringstream text;
    text << "probability: " << numberText(probability)
         << "; expected above 0 and below 1, or 0: all that the tolerances allow";
    throw std::invalid_argument(text.str());
  }
  StatisticalPlan plan;
  plan.probability = probability;
  const double rare = 1.0 - probability;
  const double enough = std::ceil(kVerifiedOutside / rare);
  if (enough > static_cast<double>(kMostSamples) / (kMostLooks + 3)) {
    std::ostringstream text;
    text << "probability: " << numberText(probability) << " takes " << enough
         << " shapes to verify; expected at most " << kMostSamples / (kMostLooks + 3);
    throw std::invalid_argument(text.str());
  }
  plan.calibration = std::max<std::size_t>(kFewest, static_cast<std::size_t>(enough));
  plan.added = plan.calibration;
  plan.verification = verification == 0 ? plan.calibration : verification;
  const auto learnt = static_cast<std::size_t>(std::ceil(kLearntOutside / rare));
  plan.learnt = std::clamp(learnt, kFewest, kMostLearnt);
  plan.learnt = std::max(kFewestLearnt, std::min(plan.learnt, kMostLearntStretches / stretches));
  if (!mostOutside(plan, 0)) {
    std::ostringstream text;
    text << "verification: " << plan.verification << " shapes; expected at least "
         << std::ceil(std::log(kFirstError) / std::log(probability)) << " to show a share of "
         << numberText(probability);
    throw std::invalid_argument(text.str());
  }
  return plan;
}

Sampler productionSampler(const Scene& scene, const EnvelopeOptions& options, std::uint64_t count) {
  return {scene, options.variables, SamplerType::monte_carlo, count, options.seed ^ kProduction};
}

SamplePlace productionPlace(const Sampler& sampler, std::uint64_t index, double time) {
  SamplePlace place{Eigen::VectorXd(static_cast<Eigen::Index>(sampler.variableCount())), time};
  sampler.sample(index, place.deviations.data());
  return place;
}

StatisticalResult holdShareOfProduction(std::vector<PhaseSearch>& searches, const Sampler& sampler,
                                        const StatisticalPlan& plan, const SolvedWitness& witness,
                                        const std::function<void(double share, std::size_t done)>& progress) {
  PhaseSearch& search = searches.front();
  std::uint64_t drawn = 0;
  const auto draw = [&](std::size_t count) {
    std::vector<SamplePlace> places;
    places.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      places.push_back(productionPlace(sampler, drawn++, search.follower().referenceTime()));
    return places;
  };
  const auto all = static_cast<double>(plan.learnt + plan.added + plan.calibration + plan.verification);
  const auto tell = [&](std::size_t before, std::size_t done) {
    progress(std::min(1.0, static_cast<double>(before + done) / all), before + done);
  };

  {
    std::vector<FollowedShape> shapes(plan.learnt);
    std::atomic<std::size_t> done{0};
    solvePlaces(searches, draw(plan.learnt),
                [&](std::size_t index, std::size_t /*phase*/, const FollowedShape& followed) {
                  shapes[index].converged = followed.converged;
                  shapes[index].message = followed.message;
                  shapes[index].shape = followed.shape;
                  shapes[index].jump = followed.jump;
                  tell(0, ++done);
                });
    takeUsual(search, shapes, leftOut(plan, plan.learnt));
  }
  {
    const ContainmentCheck check(searches);
    const std::vector<SamplePlace> places = draw(plan.added);
    std::vector<std::optional<std::pair<double, FollowedShape>>> found(places.size());
    std::atomic<std::size_t> done{0}, failed{0};
    solvePlaces(searches, places, [&](std::size_t index, std::size_t phase, const FollowedShape& followed) {
      const RandomShape shape = check.look(places[index], phase, followed);
      if (!shape.converged) ++failed;
      if (shape.converged && shape.protrusion > kWorthwhile) {
        found[index].emplace(shape.protrusion, FollowedShape());
        FollowedShape& kept = found[index]->second;
        kept.converged = true;
        kept.shape = followed.shape;
        kept.jump = followed.jump;
      }
      tell(plan.learnt, ++done);
    });
    std::vector<std::pair<double, FollowedShape>> sticking_out;
    for (auto& each : found) {
      if (each) sticking_out.push_back(std::move(*each));
    }
    const std::size_t outside = leftOut(plan, plan.added);
    takeIn(search, sticking_out, outside - std::min(outside, failed.load()));
  }

  StatisticalResult result;
  LookOptions options;
  const std::size_t learnt = plan.learnt + plan.added;
  options.progress = [&](std::size_t done) { tell(learnt, done); };
  std::vector<double> protrusions;
  const auto drawNext = [&](std::size_t /*index*/) {
    return productionPlace(sampler, drawn++, search.follower().referenceTime());
  };
  lookInBlocks(searches, plan.calibration, drawNext, options,
               [&](std::size_t /*first*/, const std::vector<RandomShape>& shapes) {
                 for (const RandomShape& shape : shapes) protrusions.push_back(protrusionOf(shape));
               });

  options.witness = witness;
  options.only_held = true;
  options.progress = [&](std::size_t done) { tell(learnt + plan.calibration, done); };
  while (!result.shown && result.looks < kMostLooks) {
    const auto allowed = mostOutside(plan, result.looks);
    if (!allowed) break;
    const std::size_t outside = likelyOutside(*allowed, plan.verification, protrusions.size());
    result.inflation = std::max(result.inflation, inflationFor(protrusions, outside));
    if (!std::isfinite(result.inflation)) {
      std::ostringstream text;
      text << "an envelope of a share of " << numberText(plan.probability) << ": "
           << std::count(protrusions.begin(), protrusions.end(), kInfinity) << " of " << protrusions.size()
           << " harnesses drawn from production have no equilibrium that the design's leads to";
      throw NotConverged(text.str());
    }
    options.inflation = result.inflation;
    ContainmentCount count(result.inflation);
    result.snapped.clear();
    result.draws = {drawn, plan.verification, {}};
    lookInBlocks(searches, plan.verification, drawNext, options,
                 [&](std::size_t first, const std::vector<RandomShape>& shapes) {
                   count.add(shapes, search.follower().reader().stretches());
                   for (std::size_t i = 0; i < shapes.size(); ++i) {
                     const RandomShape& shape = shapes[i];
                     protrusions.push_back(protrusionOf(shape));
                     if (shape.jump.size() > 0) result.snapped.push_back(shape);
                     if (protrusions.back() > result.inflation)
                       result.draws.outside.push_back(result.draws.first + first + i);
                   }
                 });
    result.containment = count.result(true, 1.0 - errorOfLook(result.looks));
    result.shown = result.containment.outside_bound <= 1.0 - plan.probability;
    ++result.looks;
  }
  return result;
}

}  // namespace cable_variation
