#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/harness/harness.h>
#include <cable_variation/math/pose.h>
#include <cable_variation/scene/link_joint.h>
#include <cable_variation/scene/measure.h>
#include <cable_variation/scene/motion.h>
#include <cable_variation/scene/scene_fault.h>
#include <cable_variation/scene/tolerance_region.h>

namespace cable_variation {

/// One visible piece of a component, with its pose in the component's frame.
struct Visual {
  std::string name;           ///< URDF: the link it belongs to
  Pose pose;                  ///< in the component's frame
  std::string mesh_resource;  ///< address for RViz (package:// or file://); empty for a primitive
  Eigen::Vector3d mesh_scale = Eigen::Vector3d::Ones();
  std::shared_ptr<const TriangleMesh>
      mesh;  ///< in metres, scale applied, in the visual's frame; primitives are tessellated
  Eigen::Vector4d color{0.65, 0.67, 0.70, 1.0};  ///< r g b a
};

/// Who says where a component is.
enum class ComponentDriver {
  scene,        ///< the scene file, or a recorded motion
  tf,           ///< another program, such as a robot's: the nodes publish no frame for it
  joint_states  ///< a robot's joints, for its links: see Component::joint
};

/// A rigid part. Its name is its tf frame. A URDF that joint states drive is one for each link: the root link
/// has the name of the whole, the others are NAME/LINK.
struct Component {
  std::string name;
  std::string parent = "world";  ///< a component, or world
  Pose pose;                     ///< in the parent's frame; of a link: its joint at LinkJoint::position
  ComponentDriver driven_by = ComponentDriver::scene;
  std::string robot;               ///< of a link that joint states drive: the root link; else empty
  std::optional<LinkJoint> joint;  ///< of such a link that is not the root
  std::vector<Visual> visuals;     ///< of a URDF as a whole: every link's, its joints at the positions given
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>
      locators;  ///< 3-2-1: point, unit direction, in its frame
};

/// Where a clip of the scene rides: the frame of `Harness::clips[i]` is
/// pose(component) * pose.
struct ClipMount {
  std::string component = "world";
  Pose pose;
};

/// Which parts cables touch instead of entering them.
struct SceneContact {
  std::vector<std::size_t> cables;      ///< indices into Harness::cables
  std::vector<std::size_t> components;  ///< of a robot's root: all its links
  double stand_off = 0.0;               ///< the gap that is kept [m]
  double skip_near_clips = 0.0;         ///< sections within this of a clip on the part do not count [m]
};

/// What a design variable moves or scales.
struct ClipTranslation {
  std::size_t clip;
  Axis axis;
};  ///< [m], in the clip's frame
struct ClipRotation {
  std::size_t clip;
  Axis axis;
};  ///< [rad], in the clip's frame
struct ClipArcLength {
  std::size_t clip;
};  ///< [m]
/// Sections and rest curvature of the cable scale in proportion, the value
/// being that at the cable's start (EI: about y; rest_curvature: a factor).
struct CableProperty {
  enum class Property { length, radius, EI, GJ, EA, density, rest_curvature };
  std::size_t cable;
  Property property;
  bool similar = false;      ///< radius: stiffness and weight follow it (a section given by its geometry)
  bool clips_scale = false;  ///< length: clips keep their fraction of it, not their distance from the start
};
struct BreakoutArcLength {
  std::size_t joint;
};  ///< [m]
struct ComponentTranslation {
  std::size_t component;
  Axis axis;
};  ///< [m], in the component's frame
struct ComponentRotation {
  std::size_t component;
  Axis axis;
};  ///< [rad]
struct LocatorDeviation {
  std::size_t component;
  std::size_t locator;
};  ///< [m]
using DesignTarget =
    std::variant<ClipTranslation, ClipRotation, ClipArcLength, CableProperty, BreakoutArcLength,
                 ComponentTranslation, ComponentRotation, LocatorDeviation>;

/// A quantity that production varies; at its nominal value nothing is changed. Its value is a deviation
/// from the scene's nominal for poses and locators (nominal 0), the quantity itself for the properties of a
/// cable and for arc lengths.
struct DesignVariable {
  std::string name;
  DesignTarget target;
  std::string unit;  ///< SI: m, rad, N m^2, N, kg/m, 1 (factor)
  double nominal = 0.0;
  double lower = 0.0;  ///< of the tolerance, as a deviation from nominal (<= 0)
  double upper = 0.0;  ///< likewise (>= 0)
  std::string distribution = "normal";
  std::map<std::string, double> distribution_parameters;
  std::vector<double> distribution_values;   ///< discrete, empirical: deviations from nominal
  std::vector<double> distribution_weights;  ///< discrete: probabilities, which add up to 1
};

/// At this time of the motions a clip is closed or opened.
struct AttachmentChange {
  std::size_t clip = 0;  ///< index into Harness::clips
  double time = 0.0;     ///< of the motions, from their start [s]
  bool attached = true;  ///< from then on
  double reach = 0.02;   ///< it takes hold of a section that is no further away than this [m]
};

/// A scene file's contents, resolved and checked.
struct Scene {
  std::string source;      ///< path of the file
  double accuracy = 1e-4;  ///< of every centreline [m]
  std::vector<Component> components;
  Harness harness;  ///< clip poses resolved to the world at the scene's own component poses
  std::vector<ClipMount> clip_mounts;  ///< one per harness clip
  std::vector<SceneContact> contacts;
  std::vector<std::size_t> contact_components;  ///< one per Harness::contacts: the part's component
  std::map<std::size_t, std::shared_ptr<const DistancePart>> contact_parts;  ///< of these components
  std::vector<DesignVariable> design_variables;
  std::vector<ToleranceRegion> tolerance_regions;
  std::vector<Correlation> correlations;
  std::vector<Measure> measures;
  std::vector<Motion> motions;
  std::vector<AttachmentChange> attachments;  ///< by time
  std::vector<SceneFault> warnings;           ///< implausible values: most often a unit that was left out
};

/// Poses of components in the world that differ from the scene's own (moved by tf or a motion).
using ComponentPoses = std::map<std::string, Pose>;

/// Pose of a component in the world; a name in `moved` takes its pose from
/// there, and so do those that ride on it. "world" is the identity.
/// Throws std::invalid_argument for an unknown name.
Pose componentPose(const Scene& scene, const std::string& component, const ComponentPoses& moved = {});

/// Values of design variables by name; the others are nominal.
using DesignValues = std::map<std::string, double>;

/// Poses in the world of all components with the design variables at `values`:
/// a component's deviation moves it and all that rides on it, also where a
/// pose comes from `moved` (which tells of components as designed).
/// Throws std::invalid_argument as harnessAt().
ComponentPoses componentPosesAt(const Scene& scene, const DesignValues& values,
                                const ComponentPoses& moved = {});

/// The harness with the design variables at `values`, its clips where the
/// components are (at the scene's own poses, or `moved`). Throws
/// std::invalid_argument that names an unknown variable, or a value that is not
/// finite or leaves the physical.
Harness harnessAt(const Scene& scene, const DesignValues& values, const ComponentPoses& moved = {});

}  // namespace cable_variation
