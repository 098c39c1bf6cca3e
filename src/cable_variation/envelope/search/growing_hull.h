#pragma once  // internal to envelope/

#include <optional>
#include <vector>

#include <cable_variation/geometry/body/convex_hull.h>

namespace cable_variation {

/// The hull of points that come bit by bit, each with a tag.
class GrowingHull {
 public:
  struct Tag {
    std::uint32_t sample = 0;  ///< that the point is of
    float share = 0.0F;        ///< of its stretch: 0 at the start, 1 at the end
  };

  /// Keeps the point for the next rebuild(), unless it is inside already or sticks out by no more than
  /// `slack` [m]. @return how far at least it sticks out of the hull as it is [m]; 0 if not kept
  double add(const Eigen::Vector3d& point, Tag tag, double slack);
  /// Takes in what was added. @return whether the hull has changed
  bool rebuild();

  bool empty() const { return !hull_; }
  const ConvexHull& hull() const { return *hull_; }
  /// Of the vertices of the hull; an added vertex has that of another.
  const std::vector<Tag>& tags() const { return tags_; }

 private:
  std::optional<ConvexHull> hull_;
  std::vector<Tag> tags_;
  std::vector<Eigen::Vector3d> waiting_;
  std::vector<Tag> waiting_tags_;
};

}  // namespace cable_variation
