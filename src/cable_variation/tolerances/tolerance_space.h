#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/scene/scene.h>
#include <cable_variation/util/counter_random.h>

namespace cable_variation {

/// The deviations that the tolerances of some design variables allow together: intervals, and the balls,
/// discs and cones that are regions. Of a region that has only some of its variables among the chosen, the
/// section through its middle.
class ToleranceSpace {
 public:
  /// Throws std::invalid_argument: an index out of range or given twice.
  ToleranceSpace(const Scene& scene, const std::vector<std::size_t>& variables);

  Eigen::Index size() const { return lower_.size(); }
  const Eigen::VectorXd& lower() const { return lower_; }  ///< of the box around it
  const Eigen::VectorXd& upper() const { return upper_; }
  /// Whether a variable's interval does not depend on the others.
  bool isInterval(Eigen::Index variable) const { return region_of_[static_cast<std::size_t>(variable)] < 0; }

  bool hasRegions() const { return !regions_.empty(); }

  /// Where gradient · x is largest. A coordinate without effect stays at `otherwise`.
  Eigen::VectorXd farthest(const Eigen::VectorXd& gradient, const Eigen::VectorXd& otherwise) const;

  /// Spread evenly.
  Eigen::VectorXd random(RandomRow& numbers) const;
  /// Spread over the limits: each interval at one of its ends with probability 1/2, each region on its
  /// surface likewise, else evenly within.
  Eigen::VectorXd randomNearLimits(RandomRow& numbers) const;

  /// Of two points within: each interval, and each region as one, from either of them, moved by up to a tenth
  /// of its width or drawn anew, half of the time at its limits.
  Eigen::VectorXd offspring(const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                            RandomRow& numbers) const;

  /// The share of the tolerances that deviations take up: 1 at a limit, 0 at none; infinity where a limit is
  /// passed that is 0.
  double share(const Eigen::VectorXd& deviations) const;

  bool contains(const Eigen::VectorXd& deviations, double relative_slack = 1e-12) const;

 private:
  struct Region {
    std::vector<Eigen::Index> coordinates;
    double radius;
  };
  static double radiusIn(const Region& region, const Eigen::VectorXd& deviations);
  Eigen::VectorXd drawn(RandomRow& numbers, double share_at_limits) const;

  Eigen::VectorXd lower_, upper_;
  std::vector<int> region_of_;  // per variable, -1: none
  std::vector<Region> regions_;
};

}  // namespace cable_variation
