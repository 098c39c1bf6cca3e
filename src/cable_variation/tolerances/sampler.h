#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/scene/scene.h>
#include <cable_variation/tolerances/marginal.h>
#include <cable_variation/tolerances/point_set.h>

namespace cable_variation {

/// Draws deviations of design variables as production does: their distributions, regions as one, correlations
/// by a Gaussian copula whose variables have the scene's correlation coefficients. The mean and covariance of
/// a sample are those of spreadOf(). By index: the same numbers whatever the number of threads.
class Sampler {
 public:
  /// @param variables indices into Scene::design_variables, each once; others do not vary
  /// @param count see PointSet
  /// Throws std::invalid_argument: an index out of range or twice, PointSet, makeDistribution(),
  /// latentCorrelation().
  Sampler(const Scene& scene, const std::vector<std::size_t>& variables, SamplerType type,
          std::uint64_t count, std::uint64_t seed);

  const PointSet& points() const { return points_; }
  std::size_t variableCount() const { return marginals_.size(); }

  /// Deviations from nominal, one per variable in their order [its unit]. Safe from several threads.
  /// @param index < points().count()
  void sample(std::uint64_t index, double* deviations) const;

 private:
  // Where a variable comes from: its coordinate of the point set, or one of a region's.
  struct Source {
    std::size_t coordinate = 0;
    bool correlated = false;
    bool of_region = false;
  };
  struct Region {
    std::size_t coordinate = 0;  // its first
    int dimensions = 2;
    double radius = 0.0;
    double sigma = 0.0;               // 0: evenly
    double share = 1.0;               // of the normal variable, within the radius
    std::array<std::size_t, 3> into;  // variables, by coordinate of the region; kNowhere: not asked for
  };

  std::size_t plan(const Scene& scene, const std::vector<std::size_t>& variables);
  void place(const Region& region, const double* point, double* deviations) const;

  std::vector<Source> sources_;
  std::vector<Region> regions_;
  std::vector<Marginal> marginals_;
  std::vector<std::size_t> correlated_;  // variables, in the order of the rows of factor_
  Eigen::MatrixXd factor_;               // lower triangular: of independent scores gives correlated ones
  PointSet points_;
};

}  // namespace cable_variation
