#pragma once  // internal to geometry/

// FCL's hierarchies above triangles, for FCL from 0.6 on, and 0.5, which Ubuntu 20.04 has and which names its
// types and headers otherwise and has vectors of its own.

#include <vector>

#include <Eigen/Core>

#if __has_include(<fcl/geometry/bvh/BVH_model.h>)
#include <fcl/geometry/bvh/BVH_model.h>
#else
#include <fcl/BVH/BVH_model.h>
#endif

namespace cable_variation {

namespace fcl_types {
#if __has_include(<fcl/geometry/bvh/BVH_model.h>)
using Vector = fcl::Vector3d;
using Box = fcl::AABBd;
using RectangleSweptSphere = fcl::RSSd;
#else
using Vector = fcl::Vec3f;  // of doubles, all the same
using Box = fcl::AABB;
using RectangleSweptSphere = fcl::RSS;
#endif
}  // namespace fcl_types

/// Builds a hierarchy over an empty model; fcl::BVH_OK, or FCL's code of what failed.
template <typename Model>
int fill(Model& model, const std::vector<Eigen::Vector3d>& vertices,
         const std::vector<fcl::Triangle>& triangles) {
  model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
  std::vector<fcl_types::Vector> points;
  points.reserve(vertices.size());
  for (const Eigen::Vector3d& vertex : vertices) points.emplace_back(vertex.x(), vertex.y(), vertex.z());
  model.addSubModel(points, triangles);
  return model.endModel();
}

}  // namespace cable_variation
