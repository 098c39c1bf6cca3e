#include <cable_variation/equilibrium/discretisation/held_contacts.h>

#include <cmath>

#include <cable_variation/rod/kernel/element_kernel.h>

namespace cable_variation {

using element::kNodes;

HeldContacts::HeldContacts(RodSystem& system) {
  if (!system.contact()) return;
  gaps_ = system.contact()->pressing();
  const auto count = static_cast<Eigen::Index>(gaps_.size());
  Eigen::MatrixXd flexibility(count, count);
  scale_.resize(count);
  yielding_.resize(gaps_.size());
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    const ContactSystem::Pressing& gap = gaps_[i];
    const auto column = static_cast<Eigen::Index>(i);
    scale_[column] = std::sqrt(gap.stiffness);
    NodalField force = system.zeroField();
    for (std::size_t a = 0; a < kNodes; ++a) {
      const auto node = static_cast<Eigen::Index>(3 * gap.element + a);
      force.spans[gap.span].col(node).head<3>() = gap.weight[a] * gap.direction;
    }
    system.gatherEnds(gap.span, force);
    system.solve(force, yielding_[i]);
    flexibility.col(column) = openedBy(yielding_[i]);
  }
  // Places nearer to each other than the elements tell apart have the same gap twice: of their forces only
  // the sum matters.
  constexpr double kTold = 1e-9;
  flexibility = scale_.asDiagonal() * flexibility * scale_.asDiagonal();
  flexibility.diagonal().array() += kTold;
  factor_.compute(flexibility);
}

Eigen::VectorXd HeldContacts::openedBy(const NodalField& motion) const {
  Eigen::VectorXd opened(static_cast<Eigen::Index>(gaps_.size()));
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    const ContactSystem::Pressing& gap = gaps_[i];
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    for (std::size_t a = 0; a < kNodes; ++a) {
      const auto node = static_cast<Eigen::Index>(3 * gap.element + a);
      x += gap.weight[a] * motion.spans[gap.span].col(node).head<3>();
    }
    opened[static_cast<Eigen::Index>(i)] = gap.direction.dot(x);
  }
  return opened;
}

Eigen::VectorXd HeldContacts::hold(const Eigen::VectorXd& given, NodalField& motion) const {
  constexpr int kRounds = 3;  // each takes what the one before left of gaps that are nearly the same
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(given.size());
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::VectorXd open = scale_.cwiseProduct(given + openedBy(motion));
    const Eigen::VectorXd more = -scale_.cwiseProduct(factor_.solve(open));
    for (std::size_t i = 0; i < gaps_.size(); ++i)
      motion.addScaled(more[static_cast<Eigen::Index>(i)], yielding_[i]);
    forces += more;
  }
  return forces;
}

Eigen::VectorXd HeldContacts::hold(NodalField& motion) const {
  return hold(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(gaps_.size())), motion);
}

}  // namespace cable_variation
