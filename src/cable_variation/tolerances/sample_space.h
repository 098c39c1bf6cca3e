#pragma once

#include <vector>

#include <Eigen/Core>

#include <cable_variation/harness/harness.h>
#include <cable_variation/scene/design_rate.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/tolerances/tolerance_space.h>
#include <cable_variation/tolerances/varied_design.h>

namespace cable_variation {

/// One of the harnesses that the tolerances allow, at one time of the motion.
struct SamplePlace {
  Eigen::VectorXd deviations;  ///< per variable, from its value in the design
  double time = 0.0;           ///< [s]
};

/// A design with its tolerances and motions: what an envelope is taken over. const and free of hidden state:
/// may be shared by threads.
class SampleSpace {
 public:
  /// Both must outlive the space. Throws std::invalid_argument: nothing varies, an index out of range or
  /// given twice, a motion without poses, two motions of one component.
  SampleSpace(const Scene& scene, const VariedDesign& design);

  const Scene& scene() const { return *scene_; }
  const ToleranceSpace& tolerances() const { return tolerances_; }
  const std::vector<const Motion*>& motions() const { return motions_; }
  /// The design itself, without deviations.
  SamplePlace designAt(double time) const;

  Harness harness(const SamplePlace& place) const;
  ComponentPoses components(const SamplePlace& place) const;  ///< of all, world
  ComponentPoses moved(double time) const;                    ///< as designed, those that are moved

  /// First-order coordinates: the variables, then per motion a shift along the world's axes [m] and a
  /// rotation vector [rad] of its component about its origin.
  Eigen::Index coordinates() const {
    return tolerances_.size() + 6 * static_cast<Eigen::Index>(motions_.size());
  }
  /// Of `place` relative to the design at time `reference`.
  Eigen::VectorXd coordinates(const SamplePlace& place, double reference) const;
  /// How the scene changes with each coordinate, at `place`.
  std::vector<DesignRate> rates(const SamplePlace& place) const;

 private:
  DesignValues values(const SamplePlace& place) const;

  const Scene* scene_;
  const VariedDesign* design_;
  ToleranceSpace tolerances_;
  std::vector<double> nominal_;  // per variable, its value in the design
  std::vector<const Motion*> motions_;
};

}  // namespace cable_variation
