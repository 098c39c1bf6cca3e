#include <cable_variation/tolerances/distribution.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/skew_normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/distributions/uniform.hpp>
#include <boost/math/distributions/weibull.hpp>

#include <cable_variation/statistics/quantile_search.h>
#include <cable_variation/tolerances/beta_distribution.h>
#include <cable_variation/tolerances/region_distribution.h>
#include <cable_variation/tolerances/sample_distribution.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

constexpr double kUsualSigma = 3.0;

// offset + scale * (a distribution of Boost.Math).
template <class Base>
class Scaled final : public Distribution {
 public:
  Scaled(const Base& base, double offset, double scale) : base_(base), offset_(offset), scale_(scale) {}

  double mean() const override { return offset_ + scale_ * boost::math::mean(base_); }
  double standardDeviation() const override { return scale_ * boost::math::standard_deviation(base_); }
  double cdf(double deviation) const override {
    const auto [low, high] = boost::math::support(base_);
    return boost::math::cdf(base_, std::clamp((deviation - offset_) / scale_, low, high));
  }
  double quantile(double probability) const override {
    return offset_ + scale_ * boost::math::quantile(base_, probability);
  }

 private:
  Base base_;
  double offset_, scale_;
};

// Boost.Math's cdf; its quantile does not converge for every shape.
class SkewNormal final : public Distribution {
 public:
  SkewNormal(double mean, double standard_deviation, double shape)
      : mean_(mean),
        standard_deviation_(standard_deviation),
        base_(baseOf(mean, standard_deviation, shape)) {}

  double mean() const override { return mean_; }
  double standardDeviation() const override { return standard_deviation_; }
  double cdf(double deviation) const override {
    return std::clamp(boost::math::cdf(base_, deviation), 0.0, 1.0);
  }
  double quantile(double probability) const override {
    constexpr double kReach = 40.0;  // standard deviations, beyond any probability that a double holds
    return quantileOf([this](double x) { return cdf(x); }, probability, mean_ - kReach * standard_deviation_,
                      mean_ + kReach * standard_deviation_);
  }

 private:
  // Mean ξ + ω δ √(2/π), variance ω² (1 - 2 δ²/π), with δ = α / √(1 + α²).
  static boost::math::skew_normal baseOf(double mean, double standard_deviation, double shape) {
    const double delta = shape / std::hypot(1.0, shape);
    const double scale = standard_deviation / std::sqrt(1.0 - 2.0 * delta * delta / M_PI);
    return {mean - scale * delta * std::sqrt(2.0 / M_PI), scale, shape};
  }

  double mean_, standard_deviation_;
  boost::math::skew_normal base_;
};

// A normal distribution about the middle of [low, high], which is k standard deviations from its ends, cut
// off at them.
class TruncatedNormal final : public Distribution {
 public:
  TruncatedNormal(double low, double high, double k)
      : middle_(0.5 * (low + high)),
        half_(0.5 * (high - low)),
        k_(std::max(k, RegionDistribution::kEven)),
        share_(std::erf(k_ / std::sqrt(2.0))) {}

  double mean() const override { return middle_; }
  // of one coordinate in a ball of one dimension
  double standardDeviation() const override { return RegionDistribution(1, half_, k_).standardDeviation(); }
  double cdf(double deviation) const override {
    const double u = std::clamp((deviation - middle_) / half_, -1.0, 1.0);
    // from the nearer end, where the difference of shares about 1 would be none
    const double beyond = std::erfc(k_ * std::abs(u) / std::sqrt(2.0)) - std::erfc(k_ / std::sqrt(2.0));
    const double within = 0.5 * beyond / share_;
    return u < 0.0 ? within : 1.0 - within;
  }
  double quantile(double probability) const override {
    // from the nearer end: the share that is cut off beyond it, and that within
    const double within = std::min(probability, 1.0 - probability);
    const double u =
        std::sqrt(2.0) / k_ * boost::math::erfc_inv(std::erfc(k_ / std::sqrt(2.0)) + 2.0 * share_ * within);
    return middle_ + std::copysign(half_ * std::clamp(u, 0.0, 1.0), probability - 0.5);
  }

 private:
  double middle_, half_, k_, share_;
};

// Constant over a share of the width in the middle, falling linearly to both ends: the sum of two uniform
// variables of widths a >= b.
class Trapezoidal final : public Distribution {
 public:
  Trapezoidal(double low, double high, double plateau)
      : low_(low),
        high_(high),
        flank_(0.5 * (1.0 - plateau) * (high - low)),
        height_(1.0 / (high - low - flank_)) {}

  double mean() const override { return 0.5 * (low_ + high_); }
  double standardDeviation() const override {
    const double a = high_ - low_ - flank_, b = flank_;
    return std::sqrt((a * a + b * b) / 12.0);
  }
  double cdf(double deviation) const override {
    const double x = std::clamp(deviation, low_, high_);
    if (x < low_ + flank_) return 0.5 * height_ * (x - low_) * (x - low_) / flank_;
    if (x > high_ - flank_) return 1.0 - 0.5 * height_ * (high_ - x) * (high_ - x) / flank_;
    return height_ * (x - low_ - 0.5 * flank_);
  }
  double quantile(double probability) const override {
    const double below = 0.5 * height_ * flank_;  // share on a flank
    if (probability < below) return low_ + std::sqrt(2.0 * flank_ * probability / height_);
    if (1.0 - probability < below) return high_ - std::sqrt(2.0 * flank_ * (1.0 - probability) / height_);
    return low_ + 0.5 * flank_ + probability / height_;
  }

 private:
  double low_, high_, flank_, height_;
};

// A design variable whose parameters are looked up and checked.
class Reader {
 public:
  explicit Reader(const DesignVariable& variable) : variable_(variable) {}

  std::unique_ptr<const Distribution> read() const {
    const std::string& type = variable_.distribution;
    if (type == "discrete" || type == "empirical") return ofSamples();
    if (!(std::isfinite(low()) && std::isfinite(high()) && low() < high())) {
      refuse("tolerance from " + shortNumber(low()) + " to " + shortNumber(high()) +
             "; expected lower < upper");
    }
    if (type == "ball" || type == "disc" || type == "cone") {
      return std::make_unique<RegionDistribution>(type == "ball" ? 3 : 2, high(),
                                                  has("sigma") ? parameter("sigma", Range::positive()) : 0.0);
    }
    return ofTolerance();
  }

 private:
  double low() const { return variable_.lower; }
  double high() const { return variable_.upper; }
  double width() const { return high() - low(); }
  double middle() const { return 0.5 * (low() + high()); }

  [[noreturn]] void refuse(const std::string& message) const {
    throw std::invalid_argument("design variable '" + variable_.name + "', distribution " +
                                variable_.distribution + ": " + message);
  }

  bool has(const char* name) const { return variable_.distribution_parameters.count(name) > 0; }

  double parameter(const char* name, const Range& range) const {
    const auto found = variable_.distribution_parameters.find(name);
    if (found == variable_.distribution_parameters.end()) refuse(std::string("'") + name + "' is missing");
    if (!range.holds(found->second)) {
      refuse(std::string(name) + " " + shortNumber(found->second) + "; expected " + range.text(""));
    }
    return found->second;
  }
  double parameter(const char* name, const Range& range, double fallback) const {
    return has(name) ? parameter(name, range) : fallback;
  }

  std::unique_ptr<const Distribution> ofTolerance() const {
    using namespace boost::math;
    const std::string& type = variable_.distribution;
    const double k = parameter("sigma", Range::positive(), kUsualSigma);
    if (type == "normal") return scaled(normal(), middle(), 0.5 * width() / k);
    if (type == "truncated_normal") return std::make_unique<TruncatedNormal>(low(), high(), k);
    if (type == "uniform") return scaled(uniform_distribution<>(), low(), width());
    if (type == "triangular") {
      const double mode = parameter("mode", {low(), high(), false}, std::clamp(0.0, low(), high()));
      return scaled(triangular(0.0, std::clamp((mode - low()) / width(), 0.0, 1.0), 1.0), low(), width());
    }
    if (type == "trapezoidal") {
      return std::make_unique<Trapezoidal>(low(), high(), parameter("plateau", {0.0, 1.0, false}, 0.5));
    }
    if (type == "beta") {
      const double alpha = parameter("alpha", Range::positive());
      return std::make_unique<BetaDistribution>(low(), high(), alpha, parameter("beta", Range::positive()));
    }
    if (type == "weibull") return ofWeibull();
    if (type == "skew_normal") {
      return std::make_unique<SkewNormal>(middle(), 0.5 * width() / k, parameter("shape", Range::any()));
    }
    refuse("there is no such distribution");
  }

  std::unique_ptr<const Distribution> ofWeibull() const {
    const double shape = parameter("shape", {0.5, 50.0, false});
    const double outside = std::erfc(kUsualSigma / std::sqrt(2.0));  // as of a normal one at 3 sigma
    const double scale =
        parameter("scale", Range::positive(), width() / std::pow(-std::log(outside), 1.0 / shape));
    return scaled(boost::math::weibull(shape, 1.0), low(), scale);
  }

  std::unique_ptr<const Distribution> ofSamples() const {
    const std::vector<double>& values = variable_.distribution_values;
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) {
      refuse("a value is not finite");
    }
    std::unique_ptr<const Distribution> result;
    if (variable_.distribution == "discrete") {
      if (values.empty() || variable_.distribution_weights.size() != values.size()) {
        refuse(std::to_string(variable_.distribution_weights.size()) + " probabilities of " +
               std::to_string(values.size()) + " values; expected one for each");
      }
      for (const double weight : variable_.distribution_weights) {
        if (!Range{0.0, 1.0, false}.holds(weight)) {
          refuse("probability " + shortNumber(weight) + "; expected between 0 and 1");
        }
      }
      result = std::make_unique<DiscreteDistribution>(values, variable_.distribution_weights);
    } else {
      if (values.size() < 2) refuse(std::to_string(values.size()) + " samples; expected 2 or more");
      result = std::make_unique<EmpiricalDistribution>(values);
    }
    if (!(result->standardDeviation() > 0.0)) refuse("all values are the same; expected others too");
    return result;
  }

  template <class Base>
  static std::unique_ptr<const Distribution> scaled(const Base& base, double offset, double scale) {
    return std::make_unique<Scaled<Base>>(base, offset, scale);
  }

  const DesignVariable& variable_;
};

}  // namespace

std::unique_ptr<const Distribution> makeDistribution(const DesignVariable& variable) {
  return Reader(variable).read();
}

}  // namespace cable_variation
