#pragma once  // internal to equilibrium/

#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/discretisation/configuration.h>

namespace cable_variation {

/// One unknown of the equilibrium, and how a station moves with it to first
/// order: displacement in the world, rotation vector in the section frame.
struct UnknownEffect {
  int unknown = 0;
  Eigen::Vector3d displacement;
  Eigen::Vector3d rotation;
};

/// The unknowns that move each station. Constraints are satisfied by the choice
/// of unknowns, so there are no multipliers: an equilibrium's Hessian in them is
/// positive definite exactly when it is a minimum under the constraints.
///
/// Clips: translations along their free axes; rotations as free components of
/// the rotation vector in the clip's frame, or as increments in the section
/// frame when all three are free. Joints: a fixed child adds none, a pivot adds
/// three rotations, a hinge its angle.
class StationUnknowns {
 public:
  StationUnknowns(const Harness& harness, const Topology& topology);

  int count() const { return count_; }
  /// The unknown for the slid arc length of a station, or -1.
  int slide(std::size_t station) const { return layout_[station].slide; }
  /// How many unknowns turn the station.
  int rotations(std::size_t station) const { return layout_[station].rotations; }
  /// Whether nothing about the station's pose is unknown.
  bool isHeld(std::size_t station) const { return layout_[station].held; }

  /// How the unknowns move every station of `configuration`.
  std::vector<std::vector<UnknownEffect>> effects(const Configuration& configuration) const;

  /// The entries of the Hessian that come from the curvature of the map from
  /// unknowns to poses, and from springs; and the springs' gradient.
  /// `moment` [N m] per station: derivative of the energy by its rotation
  /// vector (section frame), of the station alone.
  struct Curvature {
    int row, column;
    double value;
  };
  void addCurvature(const Configuration& configuration,
                    const std::vector<std::vector<UnknownEffect>>& effects,
                    std::vector<Eigen::Vector3d> moment, std::vector<Curvature>& entries) const;
  void addSprings(const Configuration& configuration, Eigen::VectorXd& gradient,
                  std::vector<Curvature>* entries) const;
  double springEnergy(const Configuration& configuration) const;

  /// Moves the stations by a step in the unknowns.
  void move(const Eigen::VectorXd& step, Configuration& configuration) const;

 private:
  struct Layout {
    int translation[3] = {-1, -1, -1};  ///< along the clip's axes (world's without a clip)
    int rotation[3] = {-1, -1, -1};
    bool rotation_vector = false;  ///< components of the rotation vector, not increments
    int hinge = -1;
    int slide = -1;
    int rotations = 0;
    bool held = false;
  };

  template <class Visit>
  void forEachSpring(const Configuration& configuration, Visit visit) const;

  const Harness& harness_;
  const Topology& topology_;
  std::vector<Layout> layout_;
  int count_ = 0;
};

}  // namespace cable_variation
