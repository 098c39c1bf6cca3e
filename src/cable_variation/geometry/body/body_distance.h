#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <cable_variation/geometry/body/convex_hull.h>
#include <cable_variation/geometry/tube_distance/distance.h>

namespace cable_variation {

/// The closest places of convex bodies and of what they are measured against.
struct BodyPair {
  double distance = 0.0;              ///< between the surfaces [m], negative: overlap
  Eigen::Vector3d on_body, on_other;  ///< of the surfaces [m]
  std::size_t body = 0;               ///< index of the body, or of the two
  std::size_t facet = 0;              ///< of its core, the one concerned
  std::size_t triangle = 0;           ///< of the part's mesh, or of the other's core
  bool undecided = false;             ///< it is not known whether a body is inside of a part that is open
};

/// The smallest distance of bodies from a part at `pose` in their frame, exact to 1e-7 m where they are
/// clear. Overlap, counted body by body (what several bodies hold together may be deeper):
/// - where the part's surface enters a body: minus the depth below the body's own surface of the point of the
///   part's surface that is deepest in it, exact too;
/// - where a body enters or lies inside a solid of the part (solids.h): minus the depth below the solid's
///   surface of the deepest corner of the body's core, minus the body's radius;
/// whichever is smaller. Of what is open of the part, corners count as inside where its winding number is
/// clear; where it is not, at a corner or at `on_body`, that is said (undecided). `on_body` is then the point
/// of the body's surface that is nearest to that deepest point, or beyond that corner. Of bodies as close to
/// 1e-12 m the first. None without bodies. Throws std::invalid_argument for a pose that is not finite.
std::optional<BodyPair> distance(const std::vector<const RoundedHull*>& bodies, const DistancePart& part,
                                 const Pose& pose);

/// The smallest distance within couples of bodies, all in one frame. Where they overlap, minus the depth to
/// which the core of one enters that of the other (either way, whichever is more), minus both radii.
using BodyCouple = std::pair<const RoundedHull*, const RoundedHull*>;
std::optional<BodyPair> distance(const std::vector<BodyCouple>& couples);

/// Triangles of the part's mesh that touch a body or lie inside, ascending. Throws as distance().
std::vector<std::uint32_t> enteringTriangles(const std::vector<const RoundedHull*>& bodies,
                                             const DistancePart& part, const Pose& pose);

}  // namespace cable_variation
