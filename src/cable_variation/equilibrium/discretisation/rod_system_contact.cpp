// The forces of contact and their stiffness, added to the elements that they press on.
#include <algorithm>

#include <cable_variation/equilibrium/discretisation/contact_system.h>
#include <cable_variation/equilibrium/discretisation/rod_system_impl.h>

namespace cable_variation {

using element::kFirstDof;
using element::kNodes;

void RodSystem::takeContacts(const RodSystem& from) {
  if (contact_) contact_->take(*from.contact_);
}

void RodSystem::freezeContacts(const RodSystem& from) {
  if (contact_) contact_->freeze(*from.contact_);
}

void RodSystem::addContact(const Configuration& configuration, bool hessian) {
  // A gap that is closed by more than this presses by so much more than it will at rest that the part's
  // curvature says nothing [m].
  constexpr double kDeep = 1e-4;
  contact_->evaluate(configuration);
  energy_.contact = contact_->energy();
  for (const ContactSystem::Pressing& at : contact_->pressing()) {
    const Element place = elementOf(at.span, at.element);
    Batch& batch = batches_[place.batch];
    const Eigen::Vector3d force = at.force * at.direction;
    for (std::size_t a = 0; a < kNodes; ++a) {
      for (int k = 0; k < 3; ++k)
        batch.energy.gradient[kFirstDof[a] + k][place.lane] -= at.weight[a] * force[k];
    }
    if (!hessian) continue;
    Eigen::Matrix3d stiffness = at.stiffness * at.direction * at.direction.transpose();
    const double bent = at.gap > -kDeep ? at.bent : 0.0;
    stiffness -= bent * at.curvature;
    for (std::size_t a = 0; a < kNodes; ++a) {
      for (std::size_t b = 0; b < kNodes; ++b) {
        const Eigen::Matrix3d block =
            at.weight[a] * at.weight[b] * stiffness + bent * at.follows[a] * at.follows[b].transpose();
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) {
            const int row = kFirstDof[a] + i, column = kFirstDof[b] + j;
            if (row < column) continue;
            batch.factor.matrix[row * (row + 1) / 2 + column][place.lane] += block(i, j);
          }
        }
      }
    }
  }
}

}  // namespace cable_variation
