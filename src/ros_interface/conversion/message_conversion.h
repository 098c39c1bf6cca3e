#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Vector3.h>
#include <geometry_msgs/Wrench.h>

#include <cable_variation/CableShapes.h>
#include <cable_variation/CableState.h>
#include <cable_variation/ClipReaction.h>
#include <cable_variation/SolveEquilibrium.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/math/pose.h>

namespace cable_variation_ros {

geometry_msgs::Vector3 toVector(const Eigen::Vector3d& vector);
geometry_msgs::Point toPoint(const Eigen::Vector3d& point);
geometry_msgs::Quaternion toQuaternion(const Eigen::Quaterniond& orientation);
geometry_msgs::Pose toPose(const cable_variation::Pose& pose);
geometry_msgs::TransformStamped toTransform(const cable_variation::Pose& pose, const std::string& parent,
                                            const std::string& frame, const ros::Time& stamp);

Eigen::Vector3d fromVector(const geometry_msgs::Vector3& vector);

/// Throws std::invalid_argument that names `what` for a coordinate that is not
/// finite, or a quaternion whose norm is further than 1e-3 from 1.
cable_variation::Pose fromPose(const geometry_msgs::Pose& pose, const std::string& what);
cable_variation::Pose fromTransform(const geometry_msgs::Transform& transform, const std::string& what);

/// `length` is the cable's own, undeformed [m].
cable_variation::CableState toCableState(const cable_variation::CableShape& shape, double length);

/// Every shape of a converged equilibrium of `harness`; empty otherwise.
cable_variation::CableShapes toCableShapes(const cable_variation::Equilibrium& equilibrium,
                                           const cable_variation::Harness& harness, const ros::Time& stamp);

/// What the clips of a converged equilibrium of `harness` do; empty otherwise.
std::vector<cable_variation::ClipReaction> toClipReactions(const cable_variation::Equilibrium& equilibrium,
                                                           const cable_variation::Harness& harness);

/// A reaction in the axes of its clip's frame, its moment about that frame's origin.
geometry_msgs::Wrench toWrench(const cable_variation::Reaction& reaction, const cable_variation::Pose& clip);

/// Everything but the status, of a converged equilibrium of `harness`.
cable_variation::SolveEquilibriumResponse toResponse(const cable_variation::Equilibrium& equilibrium,
                                                     const cable_variation::Harness& harness);

}  // namespace cable_variation_ros
