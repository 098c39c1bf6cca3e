#include <hunt/balance_check.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/rod/profile.h>
#include <hunt/rotation.h>

namespace cable_variation::hunt {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// What is allowed: forces of 1e-6 of the largest one in the harness, and of what a millionth of the accuracy
// does.
constexpr double kRelative = 1e-5;

struct Scale {
  double force = 1e-12, moment = 1e-15, length = 0.0;
};

Scale scaleOf(const Harness& harness, const Equilibrium& answer) {
  Scale scale;
  for (const CableShape& shape : answer.shapes) {
    for (const ShapePoint& point : shape.points) {
      scale.force = std::max(scale.force, point.force.norm());
      scale.moment = std::max(scale.moment, point.moment.norm());
    }
  }
  for (const Cable& cable : harness.cables) {
    const Section& section = cable.sections.front().section;
    scale.length = std::max(scale.length, cable.length);
    const double softest = std::min(section.EI_y, section.EI_z);
    scale.force = std::max(scale.force, softest / (cable.length * cable.length));
    scale.moment = std::max(scale.moment, softest / cable.length);
  }
  scale.moment = std::max(scale.moment, 0.1 * scale.force * scale.length);
  return scale;
}

struct Sides {
  const ShapePoint* before = nullptr;
  const ShapePoint* after = nullptr;
};

// The reported points just before and after an arc length.
Sides sidesAt(const CableShape& shape, double arc_length, double length) {
  Sides sides;
  for (const ShapePoint& point : shape.points) {
    if (std::abs(point.arc_length - arc_length) > 1e-6 * length) continue;
    if (sides.before == nullptr) sides.before = &point;
    sides.after = &point;
  }
  if (arc_length < 1e-6 * length) sides.before = nullptr;
  if (arc_length > (1.0 - 1e-6) * length) sides.after = nullptr;
  return sides;
}

struct Wrench {
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
};

// The resultant of all that acts from outside at one place of a cable.
Wrench given(const Harness& harness, const Equilibrium& answer, std::size_t cable, double s) {
  Wrench sum;
  const double same = 1e-6 * harness.cables[cable].length;
  const auto add = [&](const Vector3d& force, const Vector3d& moment, double sign) {
    sum.force += sign * force;
    sum.moment += sign * moment;
  };
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const Reaction& r = answer.clip_reactions[i];
    if (harness.clips[i].cable == cable && std::abs(r.arc_length - s) <= same) add(r.force, r.moment, 1.0);
  }
  for (std::size_t i = 0; i < harness.joints.size(); ++i) {
    const Joint& joint = harness.joints[i];
    const Reaction& r = answer.joint_reactions[i];
    if (joint.child == cable && std::abs(joint.child_arc_length - s) <= same) add(r.force, r.moment, 1.0);
    if (joint.parent == cable && std::abs(joint.parent_arc_length - s) <= same) add(r.force, r.moment, -1.0);
  }
  for (const PointLoad& load : harness.loads) {
    if (load.cable == cable && std::abs(load.arc_length - s) <= same) add(load.force, load.moment, 1.0);
  }
  return sum;
}

void checkPlaces(const Harness& harness, const Equilibrium& answer, const Scale& scale,
                 Violation& violation) {
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    const CableShape& shape = answer.shapes[c];
    const double length = harness.cables[c].length;
    double last = -1.0;
    for (const ShapePoint& point : shape.points) {
      if (point.arc_length - last <= 1e-6 * length && last >= 0.0) continue;
      last = point.arc_length;
      const Sides sides = sidesAt(shape, last, length);
      Wrench sum = given(harness, answer, c, last);
      if (sides.after != nullptr) {
        sum.force += sides.after->force;
        sum.moment += sides.after->moment;
      }
      if (sides.before != nullptr) {
        sum.force -= sides.before->force;
        sum.moment -= sides.before->moment;
      }
      const std::string where =
          " at " + std::to_string(1e3 * last) + " mm of '" + harness.cables[c].name + "'";
      violation.worst(sum.force.norm(), kRelative * scale.force, "forces do not balance" + where);
      violation.worst(sum.moment.norm(), kRelative * scale.moment, "moments do not balance" + where);
    }
  }
}

// Weight over the reported centreline by Simpson's rule, against all reactions and loads.
void checkWhole(const Harness& harness, const Equilibrium& answer, const Scale& scale, Violation& violation) {
  Wrench sum;
  const auto add = [&sum](const Vector3d& at, const Vector3d& force, const Vector3d& moment) {
    sum.force += force;
    sum.moment += moment + at.cross(force);
  };
  for (const Reaction& r : answer.clip_reactions) add(r.section.position, r.force, r.moment);
  for (const PointLoad& load : harness.loads) {
    add(answer.shapes[load.cable].position(load.arc_length), load.force, load.moment);
  }
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    const RodProfile profile(harness.cables[c]);
    const auto& points = answer.shapes[c].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double a = points[i - 1].arc_length, h = points[i].arc_length - a;
      if (h <= 0.0) continue;
      constexpr double kGauss[3] = {0.1127016653792583, 0.5, 0.8872983346207417};
      constexpr double kWeight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
      for (int g = 0; g < 3; ++g) {
        const double s = a + kGauss[g] * h;
        const Vector3d force = kWeight[g] * h * profile.at(s).mass_per_length * harness.gravity;
        add(answer.shapes[c].position(s), force, Vector3d::Zero());
      }
    }
  }
  violation.worst(sum.force.norm(), 10.0 * kRelative * scale.force, "all forces together do not balance");
  // about the origin; the centreline's own error moves the weight
  const double lever = scale.length + answer.clip_reactions.front().section.position.norm();
  violation.worst(sum.moment.norm(), 1e-3 * scale.force * lever, "all moments together do not balance");
}

std::string axisName(std::size_t k) { return k == 0 ? " x" : k == 1 ? " y" : " z"; }

// h of a sliding sleeve: what would push the cable along.
double configurationalForce(const ShapePoint& point, const RodProperties& rod) {
  const Quaterniond back = point.pose.orientation.conjugate();
  const Vector3d f = back * point.force, m = back * point.moment;
  return f.x() + 0.5 * f.dot(f.cwiseQuotient(rod.stiffness.head<3>())) +
         0.5 * m.dot(m.cwiseQuotient(rod.stiffness.tail<3>())) + rod.rest_curvature.dot(m);
}

void checkClip(const Harness& harness, const Equilibrium& answer, std::size_t index, const Scale& scale,
               Violation& violation) {
  using Kind = ClipFreedom::Kind;
  const Clip& clip = harness.clips[index];
  const Reaction& reaction = answer.clip_reactions[index];
  const CableShape& shape = answer.shapes[clip.cable];
  const Cable& cable = harness.cables[clip.cable];
  const std::string who = " of clip '" + clip.name + "'";
  const Pose section = shape.pose(reaction.arc_length);
  const double tiny = 1e-9;
  violation.worst((section.position - reaction.section.position).norm(), tiny + 1e-6 * cable.length,
                  "section is not where the cable is" + who);
  if (!clip.constraint.slides) {
    violation.worst(std::abs(reaction.arc_length - clip.arc_length), 1e-9 * cable.length + tiny,
                    "place" + who);
  }
  const Quaterniond to_clip = clip.pose.orientation.conjugate();
  const Vector3d offset = to_clip * (reaction.section.position - clip.pose.position);
  const Vector3d theta = rotationVector(to_clip * reaction.section.orientation);
  const Vector3d force = to_clip * reaction.force;
  // what does work on the rotation vector's components
  const Vector3d moment =
      rightJacobian(theta).transpose() * (reaction.section.orientation.conjugate() * reaction.moment);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const ClipFreedom& moves = clip.constraint.translation[k];
    const ClipFreedom& turns = clip.constraint.rotation[k];
    if (moves.kind == Kind::locked) {
      violation.worst(std::abs(offset[i]), tiny, "displacement along locked" + axisName(k) + who);
    } else {
      const double law = moves.kind == Kind::sprung ? -moves.stiffness * offset[i] : 0.0;
      violation.worst(std::abs(force[i] - law), kRelative * scale.force, "force along" + axisName(k) + who);
    }
    if (turns.kind == Kind::locked) {
      // half a turn about an axis has two vectors
      violation.worst(std::min(std::abs(theta[i]), M_PI - theta.norm() + std::abs(theta[i])), 1e-7,
                      "rotation about locked" + axisName(k) + who);
    } else {
      const double law = turns.kind == Kind::sprung ? -turns.stiffness * theta[i] : 0.0;
      violation.worst(std::abs(moment[i] - law), kRelative * scale.moment,
                      "moment about" + axisName(k) + who);
    }
  }
  if (!clip.constraint.slides) return;
  const Sides sides = sidesAt(shape, reaction.arc_length, cable.length);
  if (sides.before == nullptr || sides.after == nullptr) {
    violation.worst(1e3, 1.0, "slid off the cable: place" + who);
    return;
  }
  const RodProfile profile(cable);
  const double before =
      configurationalForce(*sides.before, profile.at(reaction.arc_length - 1e-9 * cable.length));
  const double after =
      configurationalForce(*sides.after, profile.at(reaction.arc_length + 1e-9 * cable.length));
  // made of moments, which the grid knows less well than it balances them
  constexpr double kOfGrid = 2e-3;
  violation.worst(std::abs(after - before), kOfGrid * (scale.force + std::abs(after) + std::abs(before)),
                  "configurational force jumps: sliding" + who);
}

void checkJoint(const Harness& harness, const Equilibrium& answer, std::size_t index, const Scale& scale,
                Violation& violation) {
  const Joint& joint = harness.joints[index];
  const Reaction& reaction = answer.joint_reactions[index];
  const std::string who = " of joint '" + joint.name + "'";
  const Pose parent = answer.shapes[joint.parent].pose(joint.parent_arc_length);
  const Pose child = answer.shapes[joint.child].pose(joint.child_arc_length);
  violation.worst((parent.position - child.position).norm(), 1e-9, "gap" + who);
  if (joint.type == Joint::Type::pivot) {
    violation.worst(reaction.moment.norm(), kRelative * scale.moment, "moment" + who);
    return;
  }
  Vector3d turn = rotationVector((parent.orientation * joint.rotation).conjugate() * child.orientation);
  if (joint.type == Joint::Type::hinge) {
    turn -= turn.dot(joint.axis) * joint.axis;
    violation.worst(std::abs((child.orientation * joint.axis).dot(reaction.moment)), kRelative * scale.moment,
                    "moment about the hinge" + who);
  }
  violation.worst(turn.norm(), 1e-7, "turn against" + who);
}

}  // namespace

Violation checkBalance(const Harness& harness, const Equilibrium& answer) {
  Violation violation;
  const Scale scale = scaleOf(harness, answer);
  checkPlaces(harness, answer, scale, violation);
  checkWhole(harness, answer, scale, violation);
  return violation;
}

Violation checkHolds(const Harness& harness, const Equilibrium& answer) {
  Violation violation;
  const Scale scale = scaleOf(harness, answer);
  for (std::size_t i = 0; i < harness.clips.size(); ++i) checkClip(harness, answer, i, scale, violation);
  for (std::size_t i = 0; i < harness.joints.size(); ++i) checkJoint(harness, answer, i, scale, violation);
  return violation;
}

}  // namespace cable_variation::hunt
