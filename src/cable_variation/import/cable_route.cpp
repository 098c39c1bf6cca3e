#include <cable_variation/import/cable_route.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/math/so3.h>

namespace cable_variation {

Eigen::Vector3d endTangent(const KblDocument& document, const SegmentShapes& shapes, std::size_t segment,
                           bool end) {
  if (const auto& curve = shapes.curves[segment]) return curve->at(end ? curve->length() : 0.0).tangent;
  const KblSegment& known = document.segments[segment];
  if (const auto& vector = end ? known.end_vector : known.start_vector) return *vector;
  const Eigen::Vector3d chord =
      document.nodes[known.end_node].position - document.nodes[known.start_node].position;
  return chord.norm() > 0.0 ? Eigen::Vector3d(chord.normalized()) : Eigen::Vector3d::UnitX();
}

CableRoute::CableRoute(const KblDocument& document, const SegmentShapes& shapes, const CablePath& path,
                       double spacing) {
  part_starts_.push_back(0.0);
  for (const CablePath::Part& part : path.parts) {
    const KblSegment& segment = document.segments[part.segment];
    const double length = shapes.lengths[part.segment];
    const double start = part_starts_.back();
    const auto tangentAt = [&](bool end) {  // of the part, along the cable
      const Eigen::Vector3d along = endTangent(document, shapes, part.segment, end != part.reversed);
      return part.reversed ? Eigen::Vector3d(-along) : along;
    };
    const std::size_t first = part.reversed ? segment.end_node : segment.start_node;
    const std::size_t last = part.reversed ? segment.start_node : segment.end_node;
    if (stations_.empty()) {
      add(0.0, document.nodes[first].position, tangentAt(false));
    } else {  // where two segments meet with a kink, the tangent is in the middle
      const Eigen::Vector3d both = stations_.back().tangent + tangentAt(false);
      if (both.norm() > 1e-6) stations_.back().tangent = both.normalized();
    }
    const auto& curve = shapes.curves[part.segment];
    if (curve) {
      std::vector<double> shares;  // of the segment's length, from its start node
      const int steps = std::max(2, static_cast<int>(std::ceil(length / spacing)));
      for (int i = 1; i < steps; ++i) shares.push_back(static_cast<double>(i) / steps);
      for (const KblFixingPlace& fixing : segment.fixings) {
        if (fixing.location > 0.0 && fixing.location < 1.0) shares.push_back(fixing.location);
      }
      std::sort(shares.begin(), shares.end());
      if (part.reversed) std::reverse(shares.begin(), shares.end());
      for (const double share : shares) {
        const CurvePoint point = curve->at(share * curve->length());
        const double along = part.reversed ? 1.0 - share : share;
        add(start + along * length, point.position,
            part.reversed ? Eigen::Vector3d(-point.tangent) : point.tangent);
      }
    } else {
      whole_ = false;
    }
    part_starts_.push_back(start + length);
    add(start + length, document.nodes[last].position, tangentAt(true));
  }
  Station* before = nullptr;
  for (Station& station : stations_) {
    station.orientation =
        before == nullptr
            ? so3::smallestRotation(Eigen::Vector3d::UnitX(), station.tangent)
            : (so3::smallestRotation(before->tangent, station.tangent) * before->orientation).normalized();
    before = &station;
  }
}

void CableRoute::add(double arc_length, const Eigen::Vector3d& position, const Eigen::Vector3d& tangent) {
  stations_.push_back({arc_length, position, tangent, Eigen::Quaterniond::Identity()});
}

Pose CableRoute::frameAt(double arc_length) const {
  const auto nearest =
      std::min_element(stations_.begin(), stations_.end(), [&](const Station& a, const Station& b) {
        return std::abs(a.arc_length - arc_length) < std::abs(b.arc_length - arc_length);
      });
  return {nearest->position, nearest->orientation};
}

}  // namespace cable_variation
