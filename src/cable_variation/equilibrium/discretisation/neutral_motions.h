#pragma once  // internal to equilibrium/

#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/discretisation/rod_system.h>

namespace cable_variation {

/// A motion that strains nothing: each span moves as a rigid body, and turns about its own axis besides where
/// its cable is round and straight at rest. On every grid elements feel neither.
struct NeutralMotion {
  struct OfSpan {
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< of the span's left end [m]
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();     ///< rotation vector, world [rad]
    double spin = 0.0;                                      ///< of each section about its own normal [rad]
  };
  std::vector<OfSpan> spans;
  Eigen::VectorXd unknowns;  ///< of the stations

  void addScaled(double factor, const NeutralMotion& other);
};

/// A basis of the motions that strain no span and wind no spring, that clips and joints allow, and along
/// which weight and loads do nothing either at the equilibrium at hand: what they make of the energy's second
/// derivative is less than `share` of what bending would. After evaluate() with the exact Hessian, before
/// factorise(). What slides keeps its arc length.
std::vector<NeutralMotion> neutralMotions(const RodSystem& system, const Configuration& configuration,
                                          double share);

/// What the softest span resists its first bow with [N/m]; after evaluate().
double softestBending(const RodSystem& system);

/// The motion of a grid's nodes; after evaluate().
NodalField fieldOf(const NeutralMotion& motion, const RodSystem& system, const Configuration& configuration);

/// What is free to move how: "cable 'hose' is free to turn about its own axis".
std::string describe(const NeutralMotion& motion, const RodSystem& system,
                     const Configuration& configuration);

/// Adds `field` to fields that are orthonormal in a metric, unless it is (nearly) made of them. Whether it
/// was added.
bool addOrthonormal(const RodSystem& system, const std::vector<RodSystem::Metric>& metric, NodalField field,
                    std::vector<NodalField>& fields);

}  // namespace cable_variation
