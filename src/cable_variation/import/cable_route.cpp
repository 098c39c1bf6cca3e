#include <cable_variation/import/cable_route.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/math/so3.h>

namespace cable_variation {

namespace {

// Points within a segment, from its start: where it has gone straight on for `spacing`, where it has turned,
// and where fixings are.
std::vector<CurvePoint> pointsOf(const SegmentCurve& curve, const KblSegment& segment, double spacing) {
  constexpr double kTurn = 8.0 * M_PI / 180.0;
  const std::vector<CurvePoint> samples = curve.samples();
  std::vector<CurvePoint> points;
  double last = 0.0, turned = 0.0;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const auto turn = [&](std::size_t k) {
      return std::acos(std::clamp(samples[k].tangent.dot(samples[k + 1].tangent), -1.0, 1.0));
    };
    turned += turn(i - 1);
    const double step = samples[i + 1].arc_length - samples[i].arc_length;
    if (samples[i].arc_length - last + step < spacing && turned + turn(i) < kTurn) continue;
    points.push_back(samples[i]);
    last = samples[i].arc_length;
    turned = 0.0;
  }
  for (const KblFixingPlace& fixing : segment.fixings) {
    if (fixing.location > 0.0 && fixing.location < 1.0)
      points.push_back(curve.at(fixing.location * curve.length()));
  }
  std::sort(points.begin(), points.end(),
            [](const CurvePoint& a, const CurvePoint& b) { return a.arc_length < b.arc_length; });
  return points;
}

}  // namespace

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
      std::vector<CurvePoint> points = pointsOf(*curve, segment, spacing);
      if (part.reversed) std::reverse(points.begin(), points.end());
      for (const CurvePoint& point : points) {
        const double share = point.arc_length / curve->length();
        add(start + (part.reversed ? 1.0 - share : share) * length, point.position,
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
