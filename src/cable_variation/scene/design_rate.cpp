#include <cable_variation/scene/design_rate.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>

#include <cable_variation/math/so3.h>
#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene/locating_scheme.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

// A rigid motion of the world's points: p moves by velocity + rotation × (p - about).
struct RigidRate {
  Vector3d velocity = Vector3d::Zero();
  Vector3d rotation = Vector3d::Zero();
  Vector3d about = Vector3d::Zero();

  FrameRate at(const Pose& pose) const {
    return {velocity + rotation.cross(pose.position - about), rotation};
  }
};

Vector3d unit(Axis axis) { return Vector3d::Unit(static_cast<int>(axis)); }

// exp(θ) turns by J_r δ, in its own axes, when θ grows by δ.
Vector3d turnPerRotation(const Pose& pose, const Deviation& deviation, Axis axis) {
  return pose.orientation * (so3::rightJacobian(deviation.rotation) * unit(axis));
}

class DesignDerivative {
 public:
  DesignDerivative(const Scene& scene, const DesignValues& values, const ComponentPoses& moved)
      : scene_(scene),
        deviations_(deviationsOf(scene, values)),
        frames_(componentFrames(scene, deviations_, moved)),
        locator_rates_(scene.components.size()) {
    values_.reserve(scene.design_variables.size());
    for (const DesignVariable& variable : scene.design_variables) values_.push_back(variable.nominal);
    for (const auto& [variable, value] : deviations_.quantities) values_[variable] = value;
    for (std::size_t i = 0; i < scene.harness.clips.size(); ++i) {
      const ClipMount& mount = scene.clip_mounts[i];
      carriers_.push_back(componentIndex(scene, mount.component));
      const bool in_world = carriers_.back() == ComponentFrame::kWorld;
      mounts_.push_back(in_world ? mount.pose : frames_[carriers_.back()].pose * mount.pose);
    }
  }

  DesignRate of(std::size_t variable) {
    variable_ = variable;
    rate_ = {};
    std::visit([this](const auto& target) { differentiate(target); },
               scene_.design_variables[variable].target);
    return std::move(rate_);
  }

  DesignRate ofMotion(std::size_t component, const Vector3d& velocity, const Vector3d& rotation) {
    rate_ = {};
    carry(component, {velocity, rotation, frames_[component].base.position});
    return std::move(rate_);
  }

 private:
  Pose clipPose(std::size_t clip) const { return mounts_[clip] * deviations_.clips[clip].pose(); }

  void differentiate(const ClipTranslation& target) {
    const Vector3d along = mounts_[target.clip].orientation * unit(target.axis);
    rate_.harness.clip_frames.push_back({target.clip, {along, Vector3d::Zero()}});
  }

  void differentiate(const ClipRotation& target) {
    const Vector3d turn = turnPerRotation(clipPose(target.clip), deviations_.clips[target.clip], target.axis);
    rate_.harness.clip_frames.push_back({target.clip, {Vector3d::Zero(), turn}});
  }

  void differentiate(const ClipArcLength& target) {
    rate_.harness.clip_arc_lengths.emplace_back(target.clip, 1.0);
  }

  void differentiate(const BreakoutArcLength& target) {
    rate_.harness.parent_arc_lengths.emplace_back(target.joint, 1.0);
  }

  void differentiate(const ComponentTranslation& target) {
    const ComponentFrame& frame = frames_[target.component];
    const Vector3d along = frame.base.orientation * (frame.located.orientation * unit(target.axis));
    carry(target.component, {along, Vector3d::Zero(), Vector3d::Zero()});
  }

  void differentiate(const ComponentRotation& target) {
    const Pose& pose = frames_[target.component].pose;
    const Vector3d turn = turnPerRotation(pose, deviations_.components[target.component], target.axis);
    carry(target.component, {Vector3d::Zero(), turn, pose.position});
  }

  void differentiate(const LocatorDeviation& target) {
    const ComponentFrame& frame = frames_[target.component];
    auto& rates = locator_rates_[target.component];
    if (!rates) rates = locatedRates(scene_.components[target.component].locators, frame.located);
    const FrameRate& rate = (*rates)[target.locator];
    carry(target.component, {frame.base.orientation * rate.translation,
                             frame.base.orientation * rate.rotation, frame.base * frame.located.position});
  }

  void differentiate(const CableProperty& target) {
    using Property = CableProperty::Property;
    CableRate rate;
    rate.cable = target.cable;
    if (target.property == Property::length) {
      differentiateLength(target, rate);
      rate_.harness.cables.push_back(rate);
      return;
    }
    const double value = values_[variable_];
    if (value == 0.0) {
      throw std::invalid_argument("design variable '" + scene_.design_variables[variable_].name +
                                  "': value 0; expected another, to differentiate there");
    }
    const double relative = 1.0 / value;
    switch (target.property) {
      case Property::radius:
        rate.radius = relative;
        if (target.similar) {
          rate.stiffness.head<3>().setConstant(2.0 * relative);
          rate.stiffness.tail<3>().setConstant(4.0 * relative);
          rate.mass = 2.0 * relative;
        }
        break;
      case Property::EI:
        rate.stiffness.tail<2>().setConstant(relative);
        break;
      case Property::GJ:
        rate.stiffness[3] = relative;
        break;
      case Property::EA:
        rate.stiffness[0] = relative;
        break;
      case Property::density:
        rate.mass = relative;
        break;
      case Property::rest_curvature:
        rate.rest_curvature = relative;
        break;
      case Property::length:
        break;
    }
    rate_.harness.cables.push_back(rate);
  }

  // What is attached moves as setProperty() tells.
  void differentiateLength(const CableProperty& target, CableRate& rate) {
    const Harness& harness = scene_.harness;
    const double nominal = harness.cables[target.cable].length;
    rate.length = 1.0;
    if (target.clips_scale) {
      const double length = values_[variable_];
      rate.knots = 1.0 / length;
      rate.rest_curvature = -1.0 / length;
    }
    const auto follow = [&](std::size_t cable, double arc_length, std::size_t index,
                            std::vector<std::pair<std::size_t, double>>& rates) {
      if (cable != target.cable) return;
      if (arc_length >= nominal) {
        rates.emplace_back(index, 1.0);
      } else if (target.clips_scale && arc_length > 0.0) {
        rates.emplace_back(index, arc_length / nominal);
      }
    };
    HarnessRate& rates = rate_.harness;
    for (std::size_t i = 0; i < harness.clips.size(); ++i) {
      follow(harness.clips[i].cable, harness.clips[i].arc_length, i, rates.clip_arc_lengths);
    }
    for (std::size_t i = 0; i < harness.joints.size(); ++i) {
      const Joint& joint = harness.joints[i];
      follow(joint.parent, joint.parent_arc_length, i, rates.parent_arc_lengths);
      follow(joint.child, joint.child_arc_length, i, rates.child_arc_lengths);
    }
    for (std::size_t i = 0; i < harness.loads.size(); ++i) {
      follow(harness.loads[i].cable, harness.loads[i].arc_length, i, rates.load_arc_lengths);
    }
  }

  bool ridesOn(std::size_t component, std::size_t carrier) const {
    while (component != carrier && component != ComponentFrame::kWorld) component = frames_[component].parent;
    return component == carrier;
  }

  // The component's motion is that of all that rides on it.
  void carry(std::size_t carrier, const RigidRate& motion) {
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      if (ridesOn(i, carrier)) rate_.components.emplace_back(i, motion.at(frames_[i].pose));
    }
    for (std::size_t i = 0; i < carriers_.size(); ++i) {
      if (ridesOn(carriers_[i], carrier)) rate_.harness.clip_frames.emplace_back(i, motion.at(clipPose(i)));
    }
    for (std::size_t i = 0; i < scene_.contact_components.size(); ++i) {
      const std::size_t part = scene_.contact_components[i];
      if (ridesOn(part, carrier)) rate_.harness.part_frames.emplace_back(i, motion.at(frames_[part].pose));
    }
  }

  const Scene& scene_;
  Deviations deviations_;
  std::vector<ComponentFrame> frames_;
  std::vector<std::optional<std::array<FrameRate, 6>>> locator_rates_;  // per component, once asked for
  std::vector<double> values_;         // per design variable; of deviations, not used
  std::vector<std::size_t> carriers_;  // per clip, the component it rides on
  std::vector<Pose> mounts_;           // per clip, its frame without its own deviation
  std::size_t variable_ = 0;           // being differentiated by
  DesignRate rate_;
};

}  // namespace

std::vector<DesignRate> designRates(const Scene& scene, const DesignValues& values,
                                    const ComponentPoses& moved, const std::vector<std::size_t>& variables) {
  for (const std::size_t variable : variables) {
    if (variable >= scene.design_variables.size()) {
      throw std::invalid_argument("design variable " + std::to_string(variable) + " of a scene with " +
                                  std::to_string(scene.design_variables.size()));
    }
  }
  DesignDerivative derivative(scene, values, moved);
  std::vector<DesignRate> rates;
  rates.reserve(variables.size());
  for (const std::size_t variable : variables) rates.push_back(derivative.of(variable));
  return rates;
}

std::array<DesignRate, 6> rigidMotionRates(const Scene& scene, const DesignValues& values,
                                           const ComponentPoses& moved, const std::string& component) {
  const std::size_t index = componentIndex(scene, component);
  if (index == ComponentFrame::kWorld) throw std::invalid_argument("the world does not move");
  DesignDerivative derivative(scene, values, moved);
  std::array<DesignRate, 6> rates;
  for (int axis = 0; axis < 3; ++axis) {
    const auto place = static_cast<std::size_t>(axis);
    rates[place] = derivative.ofMotion(index, Vector3d::Unit(axis), Vector3d::Zero());
    rates[place + 3] = derivative.ofMotion(index, Vector3d::Zero(), Vector3d::Unit(axis));
  }
  return rates;
}

}  // namespace cable_variation
