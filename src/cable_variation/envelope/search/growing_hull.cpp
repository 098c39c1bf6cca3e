#include <cable_variation/envelope/search/growing_hull.h>

namespace cable_variation {

double GrowingHull::add(const Eigen::Vector3d& point, Tag tag, double slack) {
  double height = 0.0;
  if (hull_) {
    height = hull_->height(point);
    if (height <= 0.0 || (height <= slack && hull_->closest(point).distance <= slack)) return 0.0;
  }
  waiting_.push_back(point);
  waiting_tags_.push_back(tag);
  return height;
}

bool GrowingHull::rebuild() {
  if (waiting_.empty()) return false;
  if (hull_) {
    const auto& vertices = hull_->surface().vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (hull_->sources()[i] == ConvexHull::kAdded) continue;
      waiting_.push_back(vertices[i]);
      waiting_tags_.push_back(tags_[i]);
    }
  }
  hull_.emplace(waiting_);
  std::vector<Tag> tags;
  tags.reserve(hull_->sources().size());
  for (const std::size_t source : hull_->sources()) {
    tags.push_back(waiting_tags_[source == ConvexHull::kAdded ? 0 : source]);
  }
  tags_ = std::move(tags);
  waiting_ = std::vector<Eigen::Vector3d>();  // and their memory
  waiting_tags_ = std::vector<Tag>();
  return true;
}

}  // namespace cable_variation
