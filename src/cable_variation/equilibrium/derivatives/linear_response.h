#pragma once  // internal to equilibrium/

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/discretisation/configuration.h>
#include <cable_variation/equilibrium/discretisation/held_contacts.h>
#include <cable_variation/equilibrium/discretisation/rod_system.h>
#include <cable_variation/harness/harness_rate.h>

namespace cable_variation {

/// A change of the harness to first order, per station and cable.
struct HarnessChange {
  Eigen::Matrix<double, 6, Eigen::Dynamic>
      carried;                  ///< motion of the stations, their unknowns held: displacement
                                ///< in the world above rotation vector in the section frame
  Eigen::Matrix3Xd frame_turn;  ///< how the axes turn along which a station's unknowns move it [rad], world
  Eigen::VectorXd arc_lengths;  ///< of stations, 0 for those that slide [m]
  std::vector<CableRate> cables;
  std::vector<std::pair<std::size_t, FrameRate>> parts;  ///< index into Harness::contacts
};

/// What an equilibrium does about a change, to first order.
struct HarnessResponse {
  NodalField motion;
  Eigen::VectorXd arc_lengths;  ///< of stations [m]
  /// Per span and element boundary, as RodSystem::sectionForce() but with the moment in the world: its
  /// change.
  std::vector<Eigen::Matrix<double, 6, Eigen::Dynamic>> section_forces;
  double elastic_energy = 0.0;     ///< [J]
  Eigen::VectorXd contact_forces;  ///< per gap that presses, ContactSystem::pressing() [N]
};

/// The implicit function theorem on the equilibrium G(z, x) = 0 of a discretised
/// harness: dz/dx = -G_z⁻¹ G_x with the factorised Hessian that the system holds.
/// Of G_x, what a moved clip does is geometry, what a moved arc length does is the
/// elements' analytic derivative, and what properties do is a central difference in
/// them alone, exact but for rounding, since G is a polynomial of degree two in each.
/// Gaps that press stay closed (HeldContacts), those at points and edges as they move.
class LinearResponse {
 public:
  /// `system` holds the exact Hessian at the equilibrium `configuration`, factorised. Keeps references to
  /// both.
  LinearResponse(RodSystem& system, const Configuration& configuration);
  ~LinearResponse();

  /// The response stays valid until the next call.
  const HarnessResponse& to(const HarnessChange& change);

 private:
  struct ExplicitChange;

  void clearExplicit();
  bool differentiateExplicitly(const HarnessChange& change);
  void differentiateProperties(const CableRate& cable);
  void addArcLengths(const Eigen::VectorXd& arc_lengths);
  Eigen::VectorXd moveParts(const HarnessChange& change);
  void addContactForces(const Eigen::VectorXd& forces);
  void addForce(const HarnessChange& change, NodalField& field) const;
  void turnAxes(const HarnessChange& change, Eigen::VectorXd& force) const;
  void findSectionForces(bool is_explicit);
  double elasticEnergy() const;

  RodSystem& system_;
  const Configuration& configuration_;
  HarnessResponse response_;
  std::vector<ExplicitChange> explicit_;  // one per batch
  bool explicit_is_clear_ = false;
  HeldContacts contacts_;
  // Per span and element: what its left end, and its right end, feel of the motion of both, inner nodes
  // eliminated.
  std::vector<std::vector<Eigen::Matrix<double, 12, 12>>> end_stiffness_;
};

}  // namespace cable_variation
