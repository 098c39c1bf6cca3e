#include <cable_variation/equilibrium/discretisation/station_unknowns.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/math/so3.h>

namespace cable_variation {
namespace {

// The same rotation by an angle of at most π, about the same axis: a spring that was wound further would act
// as if it were locked.
Eigen::Vector3d withinHalfTurn(const Eigen::Vector3d& rotation) {
  const double angle = rotation.norm();
  if (angle <= M_PI) return rotation;
  return std::remainder(angle, 2.0 * M_PI) / angle * rotation;
}

}  // namespace

StationUnknowns::StationUnknowns(const Harness& harness, const Topology& topology)
    : harness_(harness), topology_(topology), layout_(topology.stations.size()) {
  const auto add = [this] { return count_++; };
  for (std::size_t i = 0; i < topology.stations.size(); ++i) {
    const Station& station = topology.stations[i];
    Layout& layout = layout_[i];
    if (station.clip) {
      const ClipConstraint& constraint = harness.clips[*station.clip].constraint;
      layout.rotation_vector = constraint.holdsRotation();
      for (std::size_t k = 0; k < 3; ++k) {
        if (constraint.translation[k].kind != ClipFreedom::Kind::locked) layout.translation[k] = add();
      }
      for (std::size_t k = 0; k < 3; ++k) {
        if (constraint.rotation[k].kind != ClipFreedom::Kind::locked) layout.rotation[k] = add();
      }
      if (constraint.slides) layout.slide = add();
    } else if (station.joint) {
      const Joint::Type type = harness.joints[*station.joint].type;
      if (type == Joint::Type::pivot) {
        for (int& unknown : layout.rotation) unknown = add();
      }
      if (type == Joint::Type::hinge) layout.hinge = add();
    } else {
      for (int& unknown : layout.translation) unknown = add();
      for (int& unknown : layout.rotation) unknown = add();
    }
  }
  for (std::size_t i : topology.order) {
    Layout& layout = layout_[i];
    const auto none = [](const int(&unknowns)[3]) {
      return std::all_of(std::begin(unknowns), std::end(unknowns), [](int u) { return u < 0; });
    };
    const auto& parent = topology.stations[i].parent;
    layout.rotations = static_cast<int>(std::count_if(std::begin(layout.rotation), std::end(layout.rotation),
                                                      [](int u) { return u >= 0; })) +
                       (layout.hinge >= 0 ? 1 : 0);
    const auto& joint = topology.stations[i].joint;
    if (joint && harness.joints[*joint].type != Joint::Type::pivot)
      layout.rotations += layout_[*parent].rotations;
    layout.held = none(layout.translation) && none(layout.rotation) && layout.hinge < 0 &&
                  (!parent || layout_[*parent].held);
  }
}

std::vector<std::vector<UnknownEffect>> StationUnknowns::effects(const Configuration& configuration) const {
  std::vector<std::vector<UnknownEffect>> effects(layout_.size());
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  for (std::size_t i : topology_.order) {
    const Station& station = topology_.stations[i];
    const Layout& layout = layout_[i];
    std::vector<UnknownEffect>& mine = effects[i];
    if (station.joint) {
      const Joint& joint = harness_.joints[*station.joint];
      const double angle = configuration.stations[i].hinge_angle;
      const Eigen::Quaterniond relative =
          joint.type == Joint::Type::hinge ? joint.rotation * so3::exp(angle * joint.axis) : joint.rotation;
      for (const UnknownEffect& effect : effects[*station.parent]) {
        const bool turns = joint.type != Joint::Type::pivot;
        mine.push_back(
            {effect.unknown, effect.displacement, turns ? relative.conjugate() * effect.rotation : zero});
      }
      if (layout.hinge >= 0) mine.push_back({layout.hinge, zero, joint.axis});
    }
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    if (station.clip) axes = harness_.clips[*station.clip].pose.orientation.toRotationMatrix();
    const Eigen::Matrix3d turn = layout.rotation_vector
                                     ? so3::rightJacobian(configuration.stations[i].rotation)
                                     : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    for (int k = 0; k < 3; ++k) {
      if (layout.translation[k] >= 0) mine.push_back({layout.translation[k], axes.col(k), zero});
    }
    for (int k = 0; k < 3; ++k) {
      if (layout.rotation[k] >= 0) mine.push_back({layout.rotation[k], zero, turn.col(k)});
    }
  }
  return effects;
}

void StationUnknowns::addCurvature(const Configuration& configuration,
                                   const std::vector<std::vector<UnknownEffect>>& effects,
                                   std::vector<Eigen::Vector3d> moment,
                                   std::vector<Curvature>& entries) const {
  // Children turn with their parents, so their moments add to the parents', children first.
  for (auto i = topology_.order.rbegin(); i != topology_.order.rend(); ++i) {
    const Station& station = topology_.stations[*i];
    const Layout& layout = layout_[*i];
    const Eigen::Vector3d& g = moment[*i];
    if (station.joint) {
      const Joint& joint = harness_.joints[*station.joint];
      Eigen::Quaterniond relative = joint.rotation;
      if (joint.type == Joint::Type::hinge) {
        relative = relative * so3::exp(configuration.stations[*i].hinge_angle * joint.axis);
        // log(exp(u) exp(α e)) = u + α e + ½ α u × e
        for (const UnknownEffect& effect : effects[*i]) {
          if (effect.unknown == layout.hinge) continue;
          const double value = 0.5 * g.dot(effect.rotation.cross(joint.axis));
          entries.push_back({layout.hinge, effect.unknown, value});
          entries.push_back({effect.unknown, layout.hinge, value});
        }
      }
      if (joint.type != Joint::Type::pivot) moment[*station.parent] += relative * g;
    }
    if (layout.rotation_vector) {
      const Eigen::Matrix3d m = so3::rightJacobianSlope(configuration.stations[*i].rotation, g);
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          if (layout.rotation[r] >= 0 && layout.rotation[c] >= 0) {
            entries.push_back({layout.rotation[r], layout.rotation[c], m(r, c)});
          }
        }
      }
    }
  }
}

template <class Visit>
void StationUnknowns::forEachSpring(const Configuration& configuration, Visit visit) const {
  for (std::size_t i = 0; i < layout_.size(); ++i) {
    if (!topology_.stations[i].clip) continue;
    const ClipConstraint& constraint = harness_.clips[*topology_.stations[i].clip].constraint;
    const StationConfiguration& at = configuration.stations[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const ClipFreedom& along = constraint.translation[k];
      const ClipFreedom& about = constraint.rotation[k];
      if (along.kind == ClipFreedom::Kind::sprung)
        visit(layout_[i].translation[k], along.stiffness, at.offset[axis]);
      if (about.kind == ClipFreedom::Kind::sprung)
        visit(layout_[i].rotation[k], about.stiffness, at.rotation[axis]);
    }
  }
}

void StationUnknowns::addSprings(const Configuration& configuration, Eigen::VectorXd& gradient,
                                 std::vector<Curvature>* entries) const {
  forEachSpring(configuration, [&](int unknown, double stiffness, double deflection) {
    gradient[unknown] += stiffness * deflection;
    if (entries != nullptr) entries->push_back({unknown, unknown, stiffness});
  });
}

double StationUnknowns::springEnergy(const Configuration& configuration) const {
  double energy = 0.0;
  forEachSpring(configuration, [&](int, double stiffness, double deflection) {
    energy += 0.5 * stiffness * deflection * deflection;
  });
  return energy;
}

void StationUnknowns::move(const Eigen::VectorXd& step, Configuration& configuration) const {
  for (std::size_t i = 0; i < layout_.size(); ++i) {
    const Layout& layout = layout_[i];
    StationConfiguration& at = configuration.stations[i];
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      if (layout.translation[k] >= 0) translation[k] = step[layout.translation[k]];
      if (layout.rotation[k] >= 0) rotation[k] = step[layout.rotation[k]];
    }
    at.offset += translation;
    if (topology_.stations[i].clip) {
      at.pose.position += harness_.clips[*topology_.stations[i].clip].pose.orientation * translation;
    } else {
      at.pose.position += translation;
    }
    if (layout.rotation_vector) {
      at.rotation = withinHalfTurn(at.rotation + rotation);
    } else {
      at.pose.orientation = at.pose.orientation * so3::exp(rotation);
    }
    if (layout.hinge >= 0) at.hinge_angle = std::remainder(at.hinge_angle + step[layout.hinge], 2.0 * M_PI);
    if (layout.slide >= 0) at.arc_length += step[layout.slide];
  }
  placeStations(harness_, topology_, configuration);
}

}  // namespace cable_variation
