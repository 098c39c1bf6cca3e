// What presses where a harness changes: the parts' own motion, and the forces that keep gaps closed.
#include <cmath>

#include <cable_variation/equilibrium/derivatives/linear_response_impl.h>

namespace cable_variation {

using Eigen::Vector3d;
using element::kFirstDof;
using element::kNodes;

namespace {

const FrameRate& frameRateOf(const HarnessChange& change, std::size_t contact) {
  static const FrameRate still;
  for (const auto& [index, rate] : change.parts) {
    if (index == contact) return rate;
  }
  return still;
}

}  // namespace

// What opens each gap while all nodes are held [m], and what that does to the forces on the nodes: gaps that
// open press less, by their stiffness, and elsewhere. A part turns what it presses with, and its curvature
// does where it slips by; at a minimum of the gap it is pressed where that has gone.
Eigen::VectorXd LinearResponse::moveParts(const HarnessChange& change) {
  const std::vector<ContactSystem::Pressing>& gaps = contacts_.gaps();
  Eigen::VectorXd opened(static_cast<Eigen::Index>(gaps.size()));
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const ContactSystem::Pressing& gap = gaps[i];
    const FrameRate& part = frameRateOf(change, gap.contact);
    const Vector3d slip =
        part.translation +
        part.rotation.cross(gap.position - system_.harness_.contacts[gap.contact].pose.position);
    const Vector3d turn = part.rotation.cross(gap.direction);
    // the cable's radius where it is pressed
    const Span& span = system_.topology_.spans[gap.span];
    const double left = configuration_.stations[span.left].arc_length;
    const double length = configuration_.stations[span.right].arc_length - left;
    const double left_moved = change.arc_lengths[static_cast<Eigen::Index>(span.left)];
    const double right_moved = change.arc_lengths[static_cast<Eigen::Index>(span.right)];
    double along = left_moved + gap.share * (right_moved - left_moved), thicker = 0.0;
    for (const CableRate& cable : change.cables) {
      if (cable.cable != span.cable) continue;
      along -= cable.knots * (left + gap.share * length);
      thicker = cable.radius;
    }
    const double wider = thicker * gap.radius + along * gap.radius_slope / length;
    const double open = -gap.direction.dot(slip) - wider;
    opened[static_cast<Eigen::Index>(i)] = open;

    const Vector3d bent = gap.bent * (turn - gap.curvature * slip);
    double moved = 0.0;
    if (gap.sharpness > 0.0) {
      const double steeper = turn.dot(gap.tangent) - gap.along.dot(slip) - thicker * gap.radius_slope;
      moved = steeper / std::sqrt(gap.sharpness);
    }
    const RodSystem::Element at = system_.elementOf(gap.span, gap.element);
    for (std::size_t a = 0; a < kNodes; ++a) {
      const Vector3d force =
          gap.weight[a] * (bent - gap.stiffness * open * gap.direction) - gap.bent * moved * gap.follows[a];
      for (int k = 0; k < 3; ++k) explicit_[at.batch].gradient[kFirstDof[a] + k][at.lane] -= force[k];
    }
  }
  return opened;
}

void LinearResponse::addContactForces(const Eigen::VectorXd& forces) {
  const std::vector<ContactSystem::Pressing>& gaps = contacts_.gaps();
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const ContactSystem::Pressing& gap = gaps[i];
    const RodSystem::Element at = system_.elementOf(gap.span, gap.element);
    for (std::size_t a = 0; a < kNodes; ++a) {
      const Vector3d force = gap.weight[a] * forces[static_cast<Eigen::Index>(i)] * gap.direction;
      for (int k = 0; k < 3; ++k) explicit_[at.batch].gradient[kFirstDof[a] + k][at.lane] -= force[k];
    }
  }
}

}  // namespace cable_variation
