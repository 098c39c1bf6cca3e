#include <cable_variation/simulation/design_instant.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/measures/measure_context.h>
#include <cable_variation/scene/measure_traits.h>
#include <cable_variation/statistics/arc_variation.h>
#include <cable_variation/tolerances/distribution.h>
#include <cable_variation/tolerances/tolerances.h>

namespace cable_variation {
namespace {

// Stretches that shapes are followed by, in radii of the thinnest cable: their ends tell of a jump.
constexpr double kStretch = 4.0;

// Distances are prepared for samples that go so many standard deviations from the design, and a little
// further [m], since parts vary too.
constexpr double kDeparture = 4.5, kFreeDeparture = 1e-3;

// Snaps are looked for up to where a variable is once in so many samples, to each side.
constexpr double kRare = 1e-5;
// Where there are some, a sample that is not expected to move further than this share of the cables is not
// one.
constexpr double kNear = 0.02;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

StabilityAnalysis analysisOf(const SampleSpace& space, const VariedDesign& design,
                             const std::vector<std::size_t>& measures, const MeasureEvaluator& evaluator,
                             const EquilibriumSolver& solver, double time) {
  StabilityOptions options;
  options.variables = design.variables;
  options.measures = measures;
  options.values = design.values;
  options.moved = space.moved(time);
  options.low_high = false;
  StabilityAnalysis analysis = analyseStability(space.scene(), evaluator, options, solver);
  std::ostringstream what;
  what << "the design has no equilibrium";
  if (!space.motions().empty()) what << " at " << time << " s";
  requireConverged(analysis.nominal, what.str());
  return analysis;
}

// At the design's shape, as samples are solved.
EquilibriumSolver solverOf(const Harness& harness, EquilibriumSolver solver, double accuracy,
                           bool eigenvalue) {
  EquilibriumOptions options;
  options.accuracy = accuracy;
  options.eigenvalue = eigenvalue;
  solver.setOptions(options);
  const Equilibrium equilibrium = solver.update(harness);
  requireConverged(equilibrium, "the design has no equilibrium");
  return solver;
}

bool anyEigenvalue(const Scene& scene, const std::vector<std::size_t>& measures) {
  return std::any_of(measures.begin(), measures.end(),
                     [&](std::size_t index) { return traitsOf(scene.measures[index].type).eigenvalue; });
}

}  // namespace

DesignInstant::DesignInstant(const SampleSpace& space, const VariedDesign& design,
                             const std::vector<std::size_t>& measures, const MeasureEvaluator& evaluator,
                             std::size_t sections, const EquilibriumSolver& solver, double time)
    : space_(&space),
      time_(time),
      measures_(measures),
      eigenvalue_(anyEigenvalue(space.scene(), measures)),
      harness_(space.harness(space.designAt(time))),
      linear_(analysisOf(space, design, measures, evaluator, solver, time)),
      solver_(solverOf(harness_, solver, space.scene().accuracy, eigenvalue_)),
      components_(space.components(space.designAt(time))),
      evaluator_(evaluator.with(space.scene(), {harness_, linear_.nominal, components_})),
      reader_(space, stretches_, frames_) {
  for (std::size_t i = 0; i < sections; ++i)
    shares_.push_back(static_cast<double>(i) / static_cast<double>(sections - 1));
  const std::vector<CableView> views = viewsOf(harness_, linear_.nominal);
  findAxes(views, design.variables);
  evaluator_.expectNear({harness_, linear_.nominal, components_}, measures_, linear_.values,
                        kDeparture * largest_sigma_ + kFreeDeparture);
  double thinnest = std::numeric_limits<double>::infinity();
  for (const CableShape& shape : linear_.nominal.shapes) thinnest = std::min(thinnest, shape.radius);
  for (std::size_t cable = 0; cable < views.size(); ++cable) {
    const auto own = cutIntoStretches(cable, views[cable], kStretch * thinnest);
    stretches_.insert(stretches_.end(), own.begin(), own.end());
  }
  follower_.emplace(reader_, solver_, harness_, linear_.nominal, time);
  watchful_ = snapsNearby(design.variables);
  try {
    batch_.emplace(solver_);
  } catch (const std::invalid_argument&) {
    // a clip that slides or the like: every sample is followed by itself
  }
}

// Principal axes of each section's first-order covariance.
void DesignInstant::findAxes(const std::vector<CableView>& views, const std::vector<std::size_t>& variables) {
  const Eigen::MatrixXd covariance = spreadOf(space_->scene(), variables).covariance;
  const std::vector<DesignRate> rates = space_->rates(space_->designAt(time_));
  const auto count = static_cast<Eigen::Index>(variables.size());
  axes_.resize(views.size());
  for (std::size_t cable = 0; cable < views.size(); ++cable) {
    for (const double arc_length : arcLengths(cable)) {
      const Place place = views[cable].at(arc_length);
      Eigen::Matrix3Xd gradient(3, count);
      for (Eigen::Index j = 0; j < count; ++j) {
        const MeasureRates change{rates[static_cast<std::size_t>(j)],
                                  linear_.rates[static_cast<std::size_t>(j)]};
        gradient.col(j) = views[cable].rate(place, change.cable(cable)).position;
      }
      const PrincipalAxes axes = principalAxes(gradient * covariance * gradient.transpose());
      axes_[cable].push_back(axes.directions);
      if (axes.sigma[0] <= largest_sigma_) continue;
      largest_sigma_ = axes.sigma[0];
      furthest_ = gradient.transpose() * axes.directions.col(0);
    }
  }
}

bool DesignInstant::snapsNearby(const std::vector<std::size_t>& variables) const {
  const auto count = static_cast<Eigen::Index>(variables.size());
  Eigen::MatrixX2d rarest(count, 2);
  for (Eigen::Index j = 0; j < count; ++j) {
    const DesignVariable& variable = space_->scene().design_variables[variables[static_cast<std::size_t>(j)]];
    const auto distribution = makeDistribution(variable);
    rarest.row(j) << distribution->quantile(kRare), distribution->quantile(1.0 - kRare);
  }
  const auto snapsAt = [&](const Eigen::VectorXd& deviations) {
    const FollowedShape followed = follower_->followClosely({deviations, time_});
    return followed.jump.has_value() ||
           (!followed.converged && followed.equilibrium.status != EquilibriumStatus::impossible);
  };
  for (Eigen::Index j = 0; j < count; ++j) {
    for (const int side : {0, 1}) {
      if (snapsAt(rarest(j, side) * Eigen::VectorXd::Unit(count, j))) return true;
    }
  }
  if (furthest_.size() == 0) return false;
  for (const double sign : {-1.0, 1.0}) {
    // all at once at their usual spread along the gradient: as rare together as each by itself
    Eigen::VectorXd corner(count);
    double squares = 0.0;
    for (Eigen::Index j = 0; j < count; ++j) {
      corner[j] = rarest(j, sign * furthest_[j] > 0.0 ? 1 : 0);
      squares += furthest_[j] * furthest_[j] * corner[j] * corner[j];
    }
    if (squares == 0.0) continue;
    for (Eigen::Index j = 0; j < count; ++j)
      corner[j] *= std::abs(furthest_[j] * corner[j]) / std::sqrt(squares);
    if (snapsAt(corner)) return true;
  }
  return false;
}

std::vector<double> DesignInstant::arcLengths(std::size_t cable) const {
  std::vector<double> arc_lengths;
  arc_lengths.reserve(shares_.size());
  for (const double share : shares_) arc_lengths.push_back(share * harness_.cables[cable].length);
  return arc_lengths;
}

bool DesignInstant::isDoubtful(const SamplePlace& place) const {
  return watchful_ && follower_->expectedMotion(place) > kNear;
}

void DesignInstant::predict(const double* deviations, double* values) const {
  const auto count = static_cast<Eigen::Index>(linear_.variables.size());
  const Eigen::Map<const Eigen::VectorXd> at(deviations, count);
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    values[i] = linear_.one_sided[i]
                    ? kNaN
                    : linear_.values[i].value + linear_.jacobian.row(static_cast<Eigen::Index>(i)).dot(at);
  }
}

std::vector<std::optional<LinearMoments>> DesignInstant::linearMoments() const {
  std::vector<std::optional<LinearMoments>> moments(measures_.size());
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (linear_.one_sided[i]) continue;
    moments[i] = LinearMoments{linear_.values[i].value + linear_.mean_shift[row], linear_.sigma[row]};
  }
  return moments;
}

InstantSolver::InstantSolver(const DesignInstant& instant) : instant_(&instant), batch_(instant.batch_) {
  harnesses_.reserve(kSamples);
}

const std::array<SampleSolution, InstantSolver::kSamples>& InstantSolver::solve(
    const Eigen::MatrixXd& deviations) {
  const auto count = static_cast<std::size_t>(deviations.cols());
  std::array<SamplePlace, kSamples> places;
  std::array<std::size_t, kSamples> sample_of{};  // each harness's
  harnesses_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    places[i] = {deviations.col(static_cast<Eigen::Index>(i)), instant_->time_};
    samples_[i].solved_again = false;
    try {
      harnesses_.push_back(instant_->space_->harness(places[i]));
      sample_of[harnesses_.size() - 1] = i;
    } catch (const std::invalid_argument&) {
      samples_[i].outcome = SampleOutcome::impossible;
    }
  }
  if (batch_ && !harnesses_.empty()) batch_->solve(harnesses_.data(), harnesses_.size());
  for (std::size_t k = 0; k < harnesses_.size(); ++k) {
    const std::size_t i = sample_of[k];
    if (batch_ && batch_->outcome(k).converged() && !instant_->isDoubtful(places[i])) {
      samples_[i].outcome = SampleOutcome::solved;
      Equilibrium equilibrium = batch_->describe(k);
      if (instant_->eigenvalue_) equilibrium.smallest_eigenvalue = batch_->smallestEigenvalue(k);
      read(places[i], harnesses_[k], equilibrium, samples_[i]);
    } else {
      solveRobustly(places[i], samples_[i]);
    }
  }
  return samples_;
}

void InstantSolver::solveRobustly(const SamplePlace& place, SampleSolution& sample) {
  sample.solved_again = true;
  const FollowedShape followed = instant_->isDoubtful(place) ? instant_->follower_->followWatchfully(place)
                                                             : instant_->follower_->follow(place, false);
  if (followed.converged) {
    sample.outcome = followed.jump ? SampleOutcome::snapped : SampleOutcome::solved;
    read(place, followed.harness, followed.equilibrium, sample);
  } else {
    sample.outcome = followed.equilibrium.status == EquilibriumStatus::impossible
                         ? SampleOutcome::impossible
                         : SampleOutcome::not_converged;
  }
}

void InstantSolver::read(const SamplePlace& place, const Harness& harness, const Equilibrium& equilibrium,
                         SampleSolution& sample) {
  const ComponentPoses components = instant_->space_->components(place);
  const std::vector<MeasureValue> values = instant_->evaluator_.evaluate(
      {harness, equilibrium, components}, instant_->measures_, &instant_->linear_.values);
  sample.discretisation_error = equilibrium.discretisation_error;
  sample.values.clear();
  sample.undecided = false;
  for (const MeasureValue& value : values) {
    sample.values.push_back(value.value);
    sample.undecided = sample.undecided || value.undecided;
  }
  sample.points.resize(harness.cables.size());
  const auto sections = static_cast<Eigen::Index>(instant_->shares_.size());
  for (std::size_t cable = 0; cable < harness.cables.size(); ++cable) {
    sample.points[cable].resize(3, sections);
    for (Eigen::Index k = 0; k < sections; ++k) {
      sample.points[cable].col(k) = equilibrium.shapes[cable].position(
          instant_->shares_[static_cast<std::size_t>(k)] * harness.cables[cable].length);
    }
  }
}

}  // namespace cable_variation
