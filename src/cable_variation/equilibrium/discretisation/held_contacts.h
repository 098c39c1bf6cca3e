#pragma once  // internal to equilibrium/

#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cable_variation/equilibrium/discretisation/contact_system.h>
#include <cable_variation/equilibrium/discretisation/rod_system.h>

namespace cable_variation {

/// The gaps that press at an equilibrium, held closed to first order: what a motion that was solved for with
/// the finite stiffness of the augmented Lagrangian is short of one in which they do not open at all. By
/// bordering: with K = H + k G Gᵀ factorised, gaps' gradients G and S = Gᵀ K⁻¹ G, the motion changes by
/// K⁻¹ G δ with S δ = -(what the gaps open by). On motions that open no gap K is H, so that nothing of the
/// stiffness k is left.
class HeldContacts {
 public:
  /// After evaluate() and factorise() of `system`, until it does either again. Keeps a reference.
  explicit HeldContacts(RodSystem& system);

  /// The gaps held, by their number below.
  const std::vector<ContactSystem::Pressing>& gaps() const { return gaps_; }
  bool none() const { return gaps_.empty(); }

  /// Takes from a motion of solve() what opens gaps by more than -`given` [m]. Returns the forces that do it,
  /// per gap [N].
  Eigen::VectorXd hold(const Eigen::VectorXd& given, NodalField& motion) const;
  /// The same with gaps that nothing but the motion opens.
  Eigen::VectorXd hold(NodalField& motion) const;

 private:
  Eigen::VectorXd openedBy(const NodalField& motion) const;

  std::vector<ContactSystem::Pressing> gaps_;
  std::vector<NodalField> yielding_;    // per gap, K⁻¹ G [m/N]
  Eigen::VectorXd scale_;               // square roots of the gaps' stiffness
  Eigen::LLT<Eigen::MatrixXd> factor_;  // of S, scaled
};

}  // namespace cable_variation
