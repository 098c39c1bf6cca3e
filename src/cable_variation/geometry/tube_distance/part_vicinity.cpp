#include <cable_variation/geometry/tube_distance/part_vicinity.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/geometry/tube_distance/distance_part.h>
#include <cable_variation/geometry/tube_distance/tube_section.h>

namespace cable_variation {
namespace {

// Places in the part's tree of the triangles that may be within `reach` of a section's surface.
std::vector<std::uint32_t> trianglesNear(const std::vector<TubeSection>& sections, const TriangleTree& tree,
                                         double reach) {
  std::vector<bool> taken(tree.triangles.size(), false);
  for (const TubeSection& section : sections) {
    const double within = reach + section.reach + section.largestRadius();
    std::vector<std::uint32_t> open = {0};
    while (!open.empty()) {
      const TriangleTree::Node& node = tree.nodes[open.back()];
      open.pop_back();
      if (squaredGap(node.box, section.middle) > within * within) continue;
      if (node.count == 0) {
        open.push_back(node.first);
        open.push_back(node.first + 1);
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (!taken[i] && nearestPoint(tree.triangles[i], section.middle).distance <= within) taken[i] = true;
      }
    }
  }
  std::vector<std::uint32_t> places;
  for (std::uint32_t i = 0; i < taken.size(); ++i) {
    if (taken[i]) places.push_back(i);
  }
  return places;
}

}  // namespace

PartVicinity::PartVicinity(const Centreline& cable, const DistancePart& part, const Pose& pose, double reach)
    : reach_(reach) {
  const Pose to_part = pose.inverse();
  for (const Centreline::Piece& piece : cable.pieces) pieces_.push_back(pieceOf(piece, to_part));
  const TriangleTree& whole = part.impl().tree;
  const std::vector<TubeSection> sections = sectionsOf(cable, pose, {});
  const std::vector<std::uint32_t> near = trianglesNear(sections, whole, reach);
  if (near.empty()) {
    // nothing crosses it: one place tells of all, unless there are holes to go through
    outside_ = !part.impl().isOpen() && part.impl().solidsAround(sections.front().middle).empty();
    return;
  }
  TriangleMesh mesh;
  for (const std::uint32_t place : near) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Eigen::Vector3d& corner : whole.triangles[place].corners) mesh.vertices.push_back(corner);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  tree_.emplace(mesh);
  places_.reserve(near.size());
  for (const std::uint32_t number : tree_->number) places_.push_back(near[number]);
}

PartVicinity::Piece PartVicinity::pieceOf(const Centreline::Piece& piece, const Pose& to_part) {
  Piece result{piece.curve.controlPoints(0.0, 1.0), piece.start_radius, piece.end_radius};
  for (Eigen::Vector3d& point : result.control) point = to_part * point;
  return result;
}

double PartVicinity::completeWithin(const Centreline& cable, const Pose& pose) const {
  if (cable.pieces.size() != pieces_.size()) return -1.0;
  const Pose to_part = pose.inverse();
  double gone = 0.0,
         grown = 0.0;  // squared; of curves in Bézier form no point moves further than the controls
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece now = pieceOf(cable.pieces[i], to_part);
    const Piece& then = pieces_[i];
    for (std::size_t k = 0; k < now.control.size(); ++k)
      gone = std::max(gone, (now.control[k] - then.control[k]).squaredNorm());
    grown = std::max({grown, now.start_radius - then.start_radius, now.end_radius - then.end_radius});
  }
  return reach_ - std::sqrt(gone) - grown;
}

}  // namespace cable_variation
