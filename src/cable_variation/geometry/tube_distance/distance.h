#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/geometry/tube_distance/centreline.h>
#include <cable_variation/math/pose.h>

namespace cable_variation {

/// Two closest places of a cable and of what it is measured against.
struct ClosestPair {
  enum class Contact {
    clear,    ///< the value is the distance between the surfaces
    overlap,  ///< the cable's surface enters, its centreline does not: minus the depth
    pierced   ///< the centreline itself enters or lies inside; see distance()
  };
  /// Whether the cable is inside of a part that is open (PartOpenness), as its winding number at `on_cable`
  /// has it, or along the cable where it enters the part.
  enum class Side {
    known,     ///< the part is closed
    wound,     ///< within kClearWinding of a whole number: inside, or outside if that is 0
    undecided  ///< between: `distance` counts as if all that is open were outside
  };
  double distance = 0.0;  ///< [m] between the surfaces, negative: overlap
  Contact contact = Contact::clear;
  bool is_depth = false;  ///< pierced: `distance` is minus a depth and the radius, else minus the radius
  Side side = Side::known;
  double winding = 0.0;                          ///< of what is open of the part, unless the side is known
  Centreline::Place place;                       ///< on the cable
  Eigen::Vector3d on_cable;                      ///< on the centreline [m, world]
  Eigen::Vector3d on_other;                      ///< on the part, or on the other centreline [m, world]
  Eigen::Vector3d direction;                     ///< unit: ∂distance/∂on_cable = -∂distance/∂on_other
  std::optional<Centreline::Place> other_place;  ///< between cables
  std::size_t triangle = 0;                      ///< of the part
  double runner_up = 0.0;  ///< the next smallest local minimum, at another place [m]; infinity: none
                           ///< within the margin asked for
};

/// Sections of a cable that do not count, as arc lengths [m].
struct SkippedStretch {
  double start = 0.0, end = 0.0;
};

/// How far from a whole number a generalised winding number still tells inside from outside.
constexpr double kClearWinding = 0.1;

/// What keeps a part's surface, welded (mesh/welded_surface.h), from being closed.
struct PartOpenness {
  std::size_t edges = 0;  ///< without a neighbour; 0: the part is closed
  double length = 0.0;    ///< of its rims [m]
  bool isOpen() const { return edges > 0; }
};

/// A rigid part made ready for distance queries: a bounding volume hierarchy,
/// and which of its shells are closed. Immutable; may be shared by threads.
class DistancePart {
 public:
  /// Throws std::invalid_argument for a mesh without triangles.
  explicit DistancePart(const TriangleMesh& mesh);
  ~DistancePart();
  DistancePart(DistancePart&&) noexcept;
  DistancePart& operator=(DistancePart&&) noexcept;

  PartOpenness openness() const;

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

class PartVicinity;

/// What makes a search for the closest pair faster.
struct DistanceSearch {
  /// Found before, of a similar placement. This and the next change nothing in what is found.
  const ClosestPair* near = nullptr;
  /// Of the cable, and the part as it is or was placed before.
  const PartVicinity* vicinity = nullptr;
  /// A pair further apart than this [m] is of no interest: none may be given instead.
  double limit = std::numeric_limits<double>::infinity();
};

/// The closest pair of a cable and a part at `pose` (world), exact to 1e-7 m for any size and placement of
/// the triangles: the smallest distance of the part from a place of the centreline, less the radius there.
/// Within a solid of the part (solids.h) minus the depth below its surface takes the distance's place; so a
/// centreline that pierces or lies inside has minus the depth of its deepest point, minus the radius there.
/// An overlap of solids is as deep as its deepest. What is open is taken for a solid whose rims are closed by
/// caps, if its winding number says so (ClosestPair::Side) at the deepest point or another place inside.
/// Where the centreline pierces what is no solid the value is minus the radius. Ends of the cable count as
/// round: a sphere about the last point. Local minima within `margin` [m] of the smallest are looked for
/// (runner_up): more than two radii along the cable away, or seen in a direction that differs by more than
/// 0.01 rad. None when all of the cable is skipped. Throws std::invalid_argument for what is no cable, pose
/// or margin.
std::optional<ClosestPair> distance(const Centreline& cable, const DistancePart& part, const Pose& pose,
                                    const std::vector<SkippedStretch>& skipped = {}, double margin = 1e-5,
                                    const DistanceSearch& search = {});

/// Where one cable hangs on another, and how long the way through the joint from place to place must be for
/// the two to count as a pair.
struct JoinedAt {
  double on_cable = 0.0, on_other = 0.0;  ///< arc lengths of the joint [m]
  double shortest_way = 0.0;              ///< [m]
};

/// The closest pair of two cables, exact to 1e-7 m: the smallest distance of their centrelines, less both
/// radii; negative: they overlap. None if no pair of places counts.
std::optional<ClosestPair> distance(const Centreline& cable, const Centreline& other,
                                    const std::optional<JoinedAt>& joined = {}, double margin = 1e-5);

}  // namespace cable_variation
