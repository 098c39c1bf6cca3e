#include <cable_variation/tolerances/sample_space.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include <cable_variation/math/so3.h>
#include <cable_variation/scene/moving_components.h>

namespace cable_variation {

SampleSpace::SampleSpace(const Scene& scene, const VariedDesign& design)
    : scene_(&scene), design_(&design), tolerances_(scene, design.variables) {
  for (const std::size_t index : design.variables) {
    const DesignVariable& variable = scene.design_variables[index];
    const auto given = design.values.find(variable.name);
    nominal_.push_back(given == design.values.end() ? variable.nominal : given->second);
  }
  for (const std::size_t index : design.motions) {
    if (index >= scene.motions.size()) {
      throw std::invalid_argument("motion number " + std::to_string(index) + "; expected less than " +
                                  std::to_string(scene.motions.size()));
    }
    const Motion& motion = scene.motions[index];
    if (motion.samples.empty())
      throw std::invalid_argument("motion '" + motion.name + "' has no poses; expected at least one");
    for (const Motion* other : motions_) {
      if (other->component != motion.component) continue;
      throw std::invalid_argument("motions '" + other->name + "' and '" + motion.name +
                                  "' both move component '" + motion.component + "'; expected one of them");
    }
    motions_.push_back(&motion);
  }
  if (tolerances_.size() == 0 && motions_.empty())
    throw std::invalid_argument("nothing varies: expected design variables or a motion");
}

SamplePlace SampleSpace::designAt(double time) const {
  return {Eigen::VectorXd::Zero(tolerances_.size()), time};
}

DesignValues SampleSpace::values(const SamplePlace& place) const {
  DesignValues values = design_->values;
  for (std::size_t i = 0; i < nominal_.size(); ++i) {
    values[scene_->design_variables[design_->variables[i]].name] =
        nominal_[i] + place.deviations[static_cast<Eigen::Index>(i)];
  }
  return values;
}

ComponentPoses SampleSpace::moved(double time) const {
  ComponentPoses poses = design_->moved;
  for (auto& [name, pose] : posesDuring(*scene_, motions_, time)) poses[name] = pose;
  return poses;
}

Harness SampleSpace::harness(const SamplePlace& place) const {
  return harnessAt(*scene_, values(place), moved(place.time));
}

ComponentPoses SampleSpace::components(const SamplePlace& place) const {
  return componentPosesAt(*scene_, values(place), moved(place.time));
}

Eigen::VectorXd SampleSpace::coordinates(const SamplePlace& place, double reference) const {
  Eigen::VectorXd coordinates(this->coordinates());
  coordinates.head(tolerances_.size()) = place.deviations;
  const ComponentPoses there = posesDuring(*scene_, motions_, place.time);
  const ComponentPoses here = posesDuring(*scene_, motions_, reference);
  Eigen::Index next = tolerances_.size();
  for (const Motion* motion : motions_) {
    const Pose &to = there.at(motion->component), &from = here.at(motion->component);
    coordinates.segment<3>(next) = to.position - from.position;
    coordinates.segment<3>(next + 3) = so3::log(to.orientation * from.orientation.conjugate());
    next += 6;
  }
  return coordinates;
}

std::vector<DesignRate> SampleSpace::rates(const SamplePlace& place) const {
  const DesignValues at = values(place);
  const ComponentPoses where = moved(place.time);
  std::vector<DesignRate> rates = designRates(*scene_, at, where, design_->variables);
  for (const Motion* motion : motions_) {
    for (DesignRate& rate : rigidMotionRates(*scene_, at, where, motion->component)) {
      rates.push_back(std::move(rate));
    }
  }
  return rates;
}

}  // namespace cable_variation
