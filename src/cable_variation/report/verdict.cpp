#include <cable_variation/report/verdict.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cable_variation/envelope/clearance/clearance_limit.h>

namespace cable_variation {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kBeyondThreeSigma = 0.0027;  // share of a normal distribution

double indexOf(const Measure& measure, double mean, double sigma) {
  double index = std::numeric_limits<double>::infinity();
  if (measure.lower) index = std::min(index, (mean - *measure.lower) / (3.0 * sigma));
  if (measure.upper) index = std::min(index, (*measure.upper - mean) / (3.0 * sigma));
  return index;
}

Verdict byIndex(double cpk) {
  if (std::isnan(cpk)) return Verdict::unknown;
  if (cpk < 1.0) return Verdict::fail;
  return cpk < kCapable ? Verdict::marginal : Verdict::pass;
}

/// Nothing, or where it is among those that were analysed.
std::optional<std::size_t> placeOf(const std::vector<std::size_t>& all, std::size_t measure) {
  const auto found = std::find(all.begin(), all.end(), measure);
  if (found == all.end()) return std::nullopt;
  return static_cast<std::size_t>(found - all.begin());
}

// Whether a variable at a limit, the others nominal, takes the measure beyond its own: solved, not predicted.
bool isBrokenAtALimit(const Measure& measure, const std::vector<LowHigh>& solved) {
  const auto breaks = [&](double value) {
    return (measure.lower && value < *measure.lower) || (measure.upper && value > *measure.upper);
  };
  return std::any_of(solved.begin(), solved.end(),
                     [&](const LowHigh& each) { return breaks(each.low) || breaks(each.high); });
}

void judgeLinear(const Measure& measure, const StabilityAnalysis& linear, MeasureVerdict& result) {
  const auto place = placeOf(linear.measures, result.measure);
  if (!place || !linear.whyUndefined(*place).empty()) return;
  const auto row = static_cast<Eigen::Index>(*place);
  const double value = linear.values[*place].value;
  result.sigma = linear.sigma[row];
  result.worst_low = value + linear.worst_low[row];
  result.worst_high = value + linear.worst_high[row];
  if (!measure.lower && !measure.upper) return;
  result.cpk = indexOf(measure, value + linear.mean_shift[row], result.sigma);
  if (std::isnan(result.cpk)) return;
  result.verdict = byIndex(result.cpk);
  result.basis = "first order";
  if (result.verdict == Verdict::fail || linear.low_high.empty()) return;
  if (!isBrokenAtALimit(measure, linear.low_high[*place])) return;
  result.verdict = Verdict::fail;
  result.basis = "low and high";
}

void judgeSimulated(const SimulationStatistics& simulation, MeasureVerdict& result) {
  const auto place = placeOf(simulation.measures, result.measure);
  if (!place) return;
  const MeasureStatistics& s = simulation.statistics[*place];
  result.sigma = s.bestSigma().value;
  result.cpk = kNaN;
  if (!s.capability) return;
  result.cpk = s.capability->cpk;
  result.outside = s.capability->outside_at_worst;
  result.verdict = byIndex(result.cpk);
  if (result.outside > kBeyondThreeSigma) result.verdict = Verdict::fail;
  result.basis = "simulation";
}

Verdict against(const EnvelopeClearance& clearance, double limit) {
  if (clearance.worst_sample < limit) return Verdict::fail;
  return clearance.distance < limit ? Verdict::marginal : Verdict::pass;
}

Verdict worse(Verdict a, Verdict b) {
  for (const Verdict each : {Verdict::fail, Verdict::unknown, Verdict::marginal, Verdict::pass}) {
    if (a == each || b == each) return each;
  }
  return Verdict::no_limits;
}

void judgeClearances(const Scene& scene, const std::vector<EnvelopeClearance>& clearances,
                     MeasureVerdict& result) {
  const Measure& measure = scene.measures[result.measure];
  for (const EnvelopeClearance& clearance : clearances) {
    if (!isOf(measure, clearance, scene)) continue;
    const bool first = std::isnan(result.worst_low);
    result.worst_low = first ? clearance.distance : std::min(result.worst_low, clearance.distance);
    if (!measure.lower) continue;
    const Verdict verdict = against(clearance, *measure.lower);
    result.verdict = first ? verdict : worse(result.verdict, verdict);
    result.basis = "worst case";
  }
}

}  // namespace

const char* toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::marginal:
      return "marginal";
    case Verdict::fail:
      return "fail";
    case Verdict::unknown:
      return "not known";
    case Verdict::no_limits:
      break;
  }
  return "no limits";
}

std::vector<MeasureVerdict> verdictsOf(const Scene& scene, const MeasureEvidence& evidence) {
  std::vector<MeasureVerdict> verdicts;
  for (std::size_t i = 0; i < evidence.measures.size(); ++i) {
    const Measure& measure = scene.measures[evidence.measures[i]];
    const double value = evidence.values[i];
    MeasureVerdict result{evidence.measures[i], Verdict::unknown, "", value, kNaN, kNaN, kNaN, kNaN, kNaN};
    if (!std::isnan(value)) {
      result.verdict = Verdict::pass;
      result.basis = "design";
    }
    if (evidence.clearances != nullptr) judgeClearances(scene, *evidence.clearances, result);
    if (evidence.linear != nullptr) judgeLinear(measure, *evidence.linear, result);
    if (evidence.simulation != nullptr) judgeSimulated(*evidence.simulation, result);
    if (!measure.lower && !measure.upper) {
      result.verdict = Verdict::no_limits;
      result.basis = "";
    } else if (beyondLimits(measure, value)) {
      result.verdict = Verdict::fail;
      result.basis = "design";
    }
    verdicts.push_back(result);
  }
  return verdicts;
}

Verdict verdictOf(const Scene& scene, const EnvelopeClearance& clearance) {
  const std::optional<double> limit = lowerLimit(scene, clearance);
  const Verdict verdict = against(clearance, std::max(limit.value_or(0.0), 0.0));
  return verdict == Verdict::pass && !limit ? Verdict::no_limits : verdict;
}

OverallVerdict overallVerdict(const Scene& scene, const std::vector<MeasureVerdict>& measures,
                              const std::vector<EnvelopeClearance>& clearances,
                              const std::vector<std::string>& faults) {
  std::size_t judged = 0;
  std::vector<std::string> failed, marginal, unknown;
  const auto take = [&](Verdict verdict, const std::string& name) {
    if (verdict == Verdict::no_limits) return;
    ++judged;
    if (verdict == Verdict::fail) failed.push_back(name);
    if (verdict == Verdict::marginal) marginal.push_back(name);
    if (verdict == Verdict::unknown) unknown.push_back(name);
  };
  for (const MeasureVerdict& each : measures) take(each.verdict, scene.measures[each.measure].name);
  for (const EnvelopeClearance& each : clearances) {
    take(verdictOf(scene, each), scene.harness.cables[each.cable].name + " – " +
                                     (each.other ? scene.harness.cables[*each.other].name : each.component));
  }
  for (const std::string& fault : faults) take(Verdict::fail, fault);
  const auto listed = [](const std::vector<std::string>& names) {
    constexpr std::size_t kMost = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(kMost, names.size()); ++i) text += (i == 0 ? "" : ", ") + names[i];
    return names.size() > kMost ? text + " and " + std::to_string(names.size() - kMost) + " more" : text;
  };
  OverallVerdict overall;
  if (judged == 0) {
    overall = {Verdict::no_limits, "no measure has limits"};
  } else if (!failed.empty()) {
    overall = {Verdict::fail, std::to_string(failed.size()) + " of " + std::to_string(judged) +
                                  (judged == 1 ? " check" : " checks") +
                                  (failed.size() == 1 ? " fails: " : " fail: ") + listed(failed)};
  } else {
    overall = {marginal.empty() ? Verdict::pass : Verdict::marginal,
               judged == 1 ? "the one check passes" : "none of " + std::to_string(judged) + " checks fails"};
  }
  if (!marginal.empty()) overall.text += "; little room: " + listed(marginal);
  if (!unknown.empty()) {
    if (overall.verdict == Verdict::pass) overall.verdict = Verdict::unknown;
    overall.text += "; not known: " + listed(unknown);
  }
  return overall;
}

}  // namespace cable_variation
