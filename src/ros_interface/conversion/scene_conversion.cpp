#include <ros_interface/conversion/scene_conversion.h>

#include <algorithm>

#include <cable_variation/scene/enum_names.h>
#include <cable_variation/scene/moving_components.h>
#include <cable_variation/scene/target_name.h>
#include <ros_interface/conversion/contact_conversion.h>
#include <ros_interface/conversion/measure_conversion.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/scene_loading.h>

namespace cable_variation_ros {

using namespace cable_variation;

namespace {

CableInfo toInfo(const Cable& cable) {
  CableInfo info;
  info.name = cable.name;
  info.length = cable.length;
  for (const SectionAt& at : cable.sections) info.radius = std::max(info.radius, at.section.radius);
  info.mass = massOf(cable);
  const Section start = sectionAt(cable, 0.0);
  info.EA = start.EA;
  info.GA_y = start.GA_y;
  info.GA_z = start.GA_z;
  info.GJ = start.GJ;
  info.EI_y = start.EI_y;
  info.EI_z = start.EI_z;
  info.uniform = cable.sections.size() == 1;
  info.preformed = !cable.rest_curvature.empty();
  return info;
}

ComponentInfo toInfo(const Component& component) {
  ComponentInfo info;
  info.name = component.name;
  info.parent = component.parent;
  info.driven_by = nameOf(component.driven_by);
  info.robot = component.robot;
  info.joint = component.joint ? component.joint->name : "";
  info.pose = toPose(component.pose);
  for (const Visual& visual : component.visuals) {
    if (visual.mesh) info.triangles += static_cast<std::uint32_t>(visual.mesh->triangles.size());
  }
  info.locators = static_cast<std::uint32_t>(component.locators.size());
  return info;
}

JointInfo toInfo(const Joint& joint, const Harness& harness) {
  JointInfo info;
  info.name = joint.name;
  info.type = nameOf(joint.type);
  info.parent = harness.cables[joint.parent].name;
  info.parent_arc_length = joint.parent_arc_length;
  info.child = harness.cables[joint.child].name;
  info.child_arc_length = joint.child_arc_length;
  info.rotation = toQuaternion(joint.rotation);
  info.axis = toVector(joint.axis);
  return info;
}

ClipInfo toInfo(const Clip& clip, const ClipMount& mount, const Harness& harness) {
  ClipInfo info;
  info.name = clip.name;
  info.type = clip.type;
  info.cable = harness.cables[clip.cable].name;
  info.arc_length = clip.arc_length;
  info.attached = clip.attached;
  info.slides = clip.constraint.slides;
  info.component = mount.component;
  info.pose = toPose(mount.pose);
  info.world_pose = toPose(clip.pose);
  return info;
}

LoadInfo toInfo(const PointLoad& load, const Harness& harness) {
  LoadInfo info;
  info.name = load.name;
  info.cable = harness.cables[load.cable].name;
  info.arc_length = load.arc_length;
  info.force = toVector(load.force);
  info.moment = toVector(load.moment);
  return info;
}

ToleranceRegionInfo toInfo(const ToleranceRegion& region, const Scene& scene) {
  ToleranceRegionInfo info;
  info.name = region.name;
  info.shape = nameOf(region.shape);
  for (const std::size_t variable : region.variables) {
    info.variables.push_back(scene.design_variables[variable].name);
  }
  info.radius = region.radius;
  info.uniform = region.uniform;
  info.sigma = region.sigma;
  return info;
}

CorrelationInfo toInfo(const Correlation& correlation, const Scene& scene) {
  CorrelationInfo info;
  info.first = scene.design_variables[correlation.first].name;
  info.second = scene.design_variables[correlation.second].name;
  info.coefficient = correlation.coefficient;
  return info;
}

MotionInfo toInfo(const Motion& motion) {
  MotionInfo info;
  info.name = motion.name;
  info.component = motion.component;
  info.file = motion.file;
  info.topic = motion.topic;
  info.duration = motion.duration();
  info.samples = static_cast<std::uint32_t>(motion.samples.size());
  return info;
}

}  // namespace

DesignVariableInfo toInfo(const DesignVariable& variable, const Scene& scene) {
  DesignVariableInfo info;
  info.name = variable.name;
  const TargetName target = nameOf(variable.target, scene);
  info.kind = target.kind;
  info.target = target.target;
  info.member = target.member;
  info.unit = variable.unit;
  info.nominal = variable.nominal;
  info.lower = variable.lower;
  info.upper = variable.upper;
  info.distribution = variable.distribution;
  return info;
}

std::vector<DesignVariableInfo> toInfos(const Scene& scene, const std::vector<std::size_t>& variables,
                                        const cable_variation::DesignValues& values) {
  std::vector<DesignVariableInfo> infos;
  for (const std::size_t index : variables) {
    infos.push_back(toInfo(scene.design_variables[index], scene));
    const auto given = values.find(infos.back().name);
    if (given != values.end()) infos.back().nominal = given->second;
  }
  return infos;
}

GetSceneResponse toResponse(const Design& design, const ComponentPoses& moved) {
  GetSceneResponse response;
  const Scene& scene = design.scene;
  const Harness harness = harnessAt(design, {}, moved);
  response.source = scene.source;
  response.accuracy = scene.accuracy;
  response.gravity = toVector(harness.gravity);
  const std::set<std::string> moving = movingComponents(scene);
  const ComponentPoses poses = componentPosesAt(scene, design.shifted, moved);
  for (const Component& component : scene.components) {
    ComponentInfo info = toInfo(component);
    info.world_pose = toPose(poses.at(component.name));
    info.moving = moving.count(component.name) != 0;
    response.components.push_back(info);
  }
  for (const Cable& cable : harness.cables) response.cables.push_back(toInfo(cable));
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    response.clips.push_back(toInfo(harness.clips[i], scene.clip_mounts[i], harness));
  }
  for (const Joint& joint : harness.joints) response.joints.push_back(toInfo(joint, harness));
  for (const PointLoad& load : harness.loads) response.loads.push_back(toInfo(load, harness));
  response.contacts = contactInfos(harness);
  for (const DesignVariable& variable : scene.design_variables) {
    response.design_variables.push_back(toInfo(variable, scene));
  }
  for (const ToleranceRegion& region : scene.tolerance_regions) {
    response.tolerance_regions.push_back(toInfo(region, scene));
  }
  for (const Correlation& correlation : scene.correlations) {
    response.correlations.push_back(toInfo(correlation, scene));
  }
  for (const Measure& measure : scene.measures) response.measures.push_back(toInfo(measure, scene));
  for (const Motion& motion : scene.motions) response.motions.push_back(toInfo(motion));
  response.warnings = warningsOf(scene);
  return response;
}

}  // namespace cable_variation_ros
