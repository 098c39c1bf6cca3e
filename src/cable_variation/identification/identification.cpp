#include <cable_variation/identification/identification.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/SVD>
#include <unsupported/Eigen/NonLinearOptimization>

#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/identification/shape_residuals.h>
#include <cable_variation/scene/design_rate.h>
#include <cable_variation/util/chosen_indices.h>

namespace cable_variation {

namespace {

constexpr double kSmallestStep = 1e-10;  // of unknowns, relative
constexpr double kFirstStep = 0.5;       // of unknowns together: half a tolerance, or half of an e-fold
constexpr double kLost = 1e3;       // residual of a shape without an equilibrium [m]: no step leads there
constexpr double kSingular = 1e-9;  // singular values below this, over the largest, are 0

bool mustBePositive(const DesignVariable& variable) {
  const auto* property = std::get_if<CableProperty>(&variable.target);
  return property != nullptr && property->property != CableProperty::Property::rest_curvature;
}

/// A variable as the search sees it: a number of about 1.
class Unknown {
 public:
  explicit Unknown(const DesignVariable& variable)
      : nominal_(variable.nominal), log_(mustBePositive(variable) && variable.nominal > 0.0) {
    const double tolerance = 0.5 * (variable.upper - variable.lower);
    width_ = tolerance > 0.0 ? tolerance : nominal_ != 0.0 ? std::abs(nominal_) : 1.0;
  }

  double value(double x) const { return log_ ? nominal_ * std::exp(x) : nominal_ + width_ * x; }
  double slope(double x) const { return log_ ? value(x) : width_; }
  double width() const { return width_; }  ///< that its standard deviation is less than, if it is known

 private:
  double nominal_, width_ = 1.0;
  bool log_;
};

/// A shape's own harness, followed from trial to trial.
struct Followed {
  const MeasuredShape* measured;
  EquilibriumSolver solver;  // with the shape of the last trial that was taken
  EquilibriumSolver trial;   // of the last one
  Harness harness;           // likewise
  Equilibrium equilibrium;
};

EquilibriumSolver solverOf(const Scene& scene) {
  EquilibriumOptions options;
  options.accuracy = scene.accuracy;
  options.eigenvalue = false;
  return EquilibriumSolver(options);
}

DesignValues withKnown(DesignValues values, const MeasuredShape& shape) {
  for (const auto& [name, value] : shape.known) values[name] = value;
  return values;
}

void checkShapes(const Scene& scene, const std::vector<MeasuredShape>& shapes) {
  if (shapes.empty()) throw std::invalid_argument("shapes: none is given; expected one at least");
  for (const MeasuredShape& shape : shapes) {
    if (shape.cable >= scene.harness.cables.size())
      throw std::invalid_argument(shape.source + ": cable " + std::to_string(shape.cable) + " is not there");
    if (shape.points.empty()) throw std::invalid_argument(shape.source + ": no points");
  }
}

void checkTask(const Scene& scene, const IdentificationTask& task) {
  checkShapes(scene, task.shapes);
  if (task.variables.empty()) throw std::invalid_argument("unknowns: none is given; expected one at least");
  std::size_t points = 0;
  for (const MeasuredShape& shape : task.shapes) points += shape.points.size();
  for (std::size_t i = 0; i < task.variables.size(); ++i) {
    const std::string& name = scene.design_variables.at(task.variables[i]).name;
    if (std::count(task.variables.begin(), task.variables.end(), task.variables[i]) > 1)
      throw std::invalid_argument("unknowns: '" + name + "' is given twice");
    for (const MeasuredShape& shape : task.shapes) {
      if (shape.known.count(name) != 0)
        throw std::invalid_argument(shape.source + ": '" + name + "' is given, but it is to be found");
    }
  }
  if (2 * points >= task.variables.size()) return;
  throw std::invalid_argument(std::to_string(points) + " points for " +
                              std::to_string(task.variables.size()) + " unknowns; expected at least " +
                              std::to_string((task.variables.size() + 1) / 2));
}

ShapeFit fitOf(const Eigen::VectorXd& residuals) {
  ShapeFit fit;
  double sum = 0.0;
  for (Eigen::Index row = 0; row < residuals.size(); row += 3) {
    const double distance = residuals.segment<3>(row).norm();
    if (distance > fit.largest) fit.worst_point = fit.distances.size();
    fit.largest = std::max(fit.largest, distance);
    fit.distances.push_back(distance);
    sum += distance * distance;
  }
  fit.rms = std::sqrt(sum / static_cast<double>(fit.distances.size()));
  return fit;
}

/// The residuals of all shapes, as Eigen's search asks for them.
class Residuals {
 public:
  Residuals(const Scene& scene, const IdentificationTask& task) : scene_(scene), task_(task) {
    for (const std::size_t variable : task.variables)
      unknowns_.emplace_back(scene.design_variables[variable]);
    for (const MeasuredShape& shape : task.shapes) {
      Followed followed{&shape, solverOf(scene), solverOf(scene), {}, {}};
      followed.harness = harnessAt(scene, withKnown({}, shape));
      followed.equilibrium = followed.solver.solve(followed.harness);
      ++solves_;
      requireConverged(followed.equilibrium, shape.source + ": the scene's nominal values");
      followed.trial = followed.solver;
      rows_ += 3 * static_cast<Eigen::Index>(shape.points.size());
      shapes_.push_back(std::move(followed));
    }
  }

  int inputs() const { return static_cast<int>(unknowns_.size()); }
  int values() const { return static_cast<int>(rows_); }
  std::size_t solves() const { return solves_; }
  const std::vector<Unknown>& unknowns() const { return unknowns_; }

  DesignValues design(const Eigen::VectorXd& x) const {
    DesignValues values;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      values[scene_.design_variables[task_.variables[i]].name] =
          unknowns_[i].value(x[static_cast<Eigen::Index>(i)]);
    }
    return values;
  }

  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& residuals) {
    residuals.setConstant(rows_, kLost);
    if (!solve(x)) return 0;
    Eigen::Index row = 0;
    for (const Followed& shape : shapes_) {
      const Eigen::VectorXd own =
          shapeResiduals(shape.harness, shape.equilibrium, *shape.measured, {}).values;
      residuals.segment(row, own.size()) = own;
      row += own.size();
    }
    return 0;
  }

  /// Eigen asks for it where it goes on from.
  int df(const Eigen::VectorXd& x, Eigen::MatrixXd& rates) {
    rates.setZero(rows_, inputs());
    if (!solve(x)) return -1;
    Eigen::Index row = 0;
    for (Followed& shape : shapes_) {
      shape.solver = shape.trial;
      std::vector<HarnessRate> variables;
      for (DesignRate& rate : designRates(scene_, withKnown(design(x), *shape.measured), {}, task_.variables))
        variables.push_back(std::move(rate.harness));
      const std::vector<EquilibriumRate> of = shape.solver.differentiate(variables);
      const Eigen::MatrixXd own = shapeResiduals(shape.harness, shape.equilibrium, *shape.measured, of).rates;
      for (Eigen::Index k = 0; k < own.cols(); ++k)
        rates.block(row, k, own.rows(), 1) = own.col(k) * unknowns_[static_cast<std::size_t>(k)].slope(x[k]);
      row += own.rows();
    }
    return 0;
  }

 private:
  bool solve(const Eigen::VectorXd& x) {
    if (solved_at_.size() == x.size() && solved_at_ == x) return true;
    solved_at_.resize(0);
    for (Followed& shape : shapes_) {
      if (task_.check) task_.check();
      try {
        shape.harness = harnessAt(scene_, withKnown(design(x), *shape.measured));
      } catch (const std::invalid_argument&) {
        return false;  // out of what is physical
      }
      shape.trial = shape.solver;
      shape.equilibrium = shape.trial.update(shape.harness);
      ++solves_;
      if (!shape.equilibrium.converged()) return false;
    }
    solved_at_ = x;
    return true;
  }

  const Scene& scene_;
  const IdentificationTask& task_;
  std::vector<Unknown> unknowns_;
  std::vector<Followed> shapes_;
  Eigen::Index rows_ = 0;
  std::size_t solves_ = 0;
  Eigen::VectorXd solved_at_;
};

/// Standard deviations and correlations of the unknowns [their widths], from what they do to residuals.
/// @param accuracy of the shapes [m]: whatever is left of the distances, they are known no better
void tellSpread(const Eigen::MatrixXd& rates, const Eigen::VectorXd& residuals, double accuracy,
                Identification& result) {
  const Eigen::Index count = rates.cols();
  Eigen::Index directions = 0;  // in which a point tells something
  for (Eigen::Index row = 0; row < rates.rows(); ++row) {
    const bool along = row % 3 == 2;
    if (!along || residuals[row] != 0.0 || rates.row(row).squaredNorm() > 0.0) ++directions;
  }
  const double freedom = static_cast<double>(directions - count);
  result.noise =
      freedom > 0.0 ? residuals.norm() / std::sqrt(freedom) : std::numeric_limits<double>::infinity();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rates, Eigen::ComputeThinV);
  const Eigen::VectorXd& singular = svd.singularValues();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd unknown = Eigen::VectorXd::Zero(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::VectorXd direction = svd.matrixV().col(k);
    if (singular[k] <= kSingular * singular[0] || !(singular[k] > 0.0)) {
      unknown += direction.cwiseAbs2();
    } else {
      covariance += direction * direction.transpose() / (singular[k] * singular[k]);
    }
  }
  const double known = std::max(result.noise, accuracy);
  covariance *= known * known;
  result.deviations = covariance.diagonal().cwiseSqrt();
  result.correlation = Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    if (unknown[i] > kSingular) result.deviations[i] = std::numeric_limits<double>::infinity();
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const double product = result.deviations[i] * result.deviations[j];
      if (i != j)
        result.correlation(i, j) = std::isfinite(product) && product > 0.0 ? covariance(i, j) / product : 0.0;
    }
  }
}

/// Of shapes that nothing was fitted to: each point tells two directions.
double noiseOf(const std::vector<ShapeFit>& fits) {
  double squares = 0.0, directions = 0.0;
  for (const ShapeFit& fit : fits) {
    for (const double distance : fit.distances) squares += distance * distance;
    directions += 2.0 * static_cast<double>(fit.distances.size());
  }
  return std::sqrt(squares / directions);
}

/// All unknowns at once; deviations are in their widths.
Identification fitAll(const Scene& scene, const IdentificationTask& task) {
  Residuals residuals(scene, task);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(residuals.inputs());
  Eigen::LevenbergMarquardt<Residuals> search(residuals);
  // Unknowns are of one size already; the first step is no longer than this.
  search.useExternalScaling = true;
  search.diag.setOnes(x.size());
  search.parameters.factor = kFirstStep;
  search.parameters.xtol = kSmallestStep;
  search.parameters.ftol = kSmallestStep;
  search.parameters.maxfev = static_cast<Eigen::Index>(task.most_solves / task.shapes.size() + 1);
  const auto end = search.minimize(x);

  Identification result;
  result.converged = end != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation &&
                     end != Eigen::LevenbergMarquardtSpace::UserAsked;
  Eigen::VectorXd left;
  Eigen::MatrixXd rates;
  residuals(x, left);
  residuals.df(x, rates);
  const std::vector<Unknown>& unknowns = residuals.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    result.values.push_back(unknowns[i].value(x[k]));
    rates.col(k) *= unknowns[i].width() / unknowns[i].slope(x[k]);
  }
  tellSpread(rates, left, scene.accuracy, result);
  Eigen::Index row = 0;
  for (const MeasuredShape& shape : task.shapes) {
    const auto rows = 3 * static_cast<Eigen::Index>(shape.points.size());
    result.fits.push_back(fitOf(left.segment(row, rows)));
    row += rows;
  }
  result.solves = residuals.solves();
  return result;
}

/// Of fitAll() for some of the unknowns, as of all: the others are held at their nominal values.
Identification widened(const Scene& scene, const IdentificationTask& task,
                       const std::vector<std::size_t>& fitted, const Identification& found) {
  const auto count = static_cast<Eigen::Index>(task.variables.size());
  Identification all = found;
  all.values.clear();
  all.deviations = Eigen::VectorXd::Constant(count, std::numeric_limits<double>::infinity());
  all.correlation = Eigen::MatrixXd::Identity(count, count);
  all.determined.assign(task.variables.size(), false);
  for (const std::size_t variable : task.variables)
    all.values.push_back(scene.design_variables[variable].nominal);
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const auto own = static_cast<Eigen::Index>(i), whole = static_cast<Eigen::Index>(fitted[i]);
    const double width = Unknown(scene.design_variables[task.variables[fitted[i]]]).width();
    all.values[fitted[i]] = found.values[i];
    all.determined[fitted[i]] = true;
    all.deviations[whole] = width * found.deviations[own];
    for (std::size_t j = 0; j < fitted.size(); ++j)
      all.correlation(whole, static_cast<Eigen::Index>(fitted[j])) =
          found.correlation(own, static_cast<Eigen::Index>(j));
  }
  return all;
}

}  // namespace

Identification identify(const Scene& scene, const IdentificationTask& task) {
  checkTask(scene, task);
  std::vector<std::size_t> fitted = allIndices(task.variables.size());  // into task.variables
  std::size_t solves = 0;
  while (!fitted.empty()) {
    IdentificationTask part = task;
    part.variables.clear();
    for (const std::size_t i : fitted) part.variables.push_back(task.variables[i]);
    Identification found = fitAll(scene, part);
    found.solves = solves += found.solves;
    Eigen::Index worst = 0;
    if (found.deviations.maxCoeff(&worst) < 1.0) return widened(scene, task, fitted, found);
    fitted.erase(fitted.begin() + worst);
  }
  Identification none;
  none.fits = compare(scene, {}, task.shapes);
  none.noise = noiseOf(none.fits);
  none.solves = solves;
  none.converged = true;
  return widened(scene, task, {}, none);
}

std::vector<ShapeFit> compare(const Scene& scene, const DesignValues& values,
                              const std::vector<MeasuredShape>& shapes) {
  checkShapes(scene, shapes);
  std::vector<ShapeFit> fits;
  for (const MeasuredShape& shape : shapes) {
    EquilibriumSolver solver = solverOf(scene);
    const Harness harness = harnessAt(scene, withKnown(values, shape));
    const Equilibrium equilibrium = solver.solve(harness);
    requireConverged(equilibrium, shape.source);
    fits.push_back(fitOf(shapeResiduals(harness, equilibrium, shape, {}).values));
  }
  return fits;
}

}  // namespace cable_variation
