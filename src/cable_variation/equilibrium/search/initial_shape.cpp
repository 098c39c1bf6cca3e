#include <cable_variation/equilibrium/search/initial_shape.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <cable_variation/equilibrium/search/guide_curve.h>
#include <cable_variation/equilibrium/search/meeting_points.h>
#include <cable_variation/math/so3.h>
#include <cable_variation/rod/kernel/element_kernel.h>

namespace cable_variation {
namespace {

bool holdsPosition(const Harness& harness, const Station& station) {
  return station.joint || (station.clip && harness.clips[*station.clip].constraint.holdsPosition());
}

bool holdsDirection(const Harness& harness, const Station& station) {
  if (station.joint) return harness.joints[*station.joint].type != Joint::Type::pivot;
  if (!station.clip) return false;
  const auto& rotation = harness.clips[*station.clip].constraint.rotation;
  return rotation[1].kind != ClipFreedom::Kind::free || rotation[2].kind != ClipFreedom::Kind::free;
}

bool holdsRoll(const Harness& harness, const Station& station) {
  if (station.joint) return harness.joints[*station.joint].type != Joint::Type::pivot;
  return station.clip && harness.clips[*station.clip].constraint.rotation[0].kind != ClipFreedom::Kind::free;
}

// Cables so that a cable comes after those its joints hang it on.
std::vector<std::size_t> cablesParentsFirst(const Harness& harness) {
  std::vector<std::size_t> order;
  std::vector<bool> placed(harness.cables.size(), false);
  while (order.size() < harness.cables.size()) {
    const std::size_t before = order.size();
    for (std::size_t c = 0; c < harness.cables.size(); ++c) {
      if (placed[c]) continue;
      const bool ready = std::all_of(harness.joints.begin(), harness.joints.end(),
                                     [&](const Joint& j) { return j.child != c || placed[j.parent]; });
      if (!ready) continue;
      placed[c] = true;
      order.push_back(c);
    }
    if (order.size() == before) {  // cables that hang on each other: any of them first
      const auto next =
          static_cast<std::size_t>(std::find(placed.begin(), placed.end(), false) - placed.begin());
      placed[next] = true;
      order.push_back(next);
    }
  }
  return order;
}

Eigen::Vector3d bulgeDirection(Routing::Bulge bulge, const Eigen::Vector3d& chord,
                               const Eigen::Vector3d& gravity) {
  Eigen::Vector3d down =
      gravity.norm() > 0.0 ? Eigen::Vector3d(gravity.normalized()) : -Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d along =
      chord.norm() > 0.0 ? Eigen::Vector3d(chord.normalized()) : Eigen::Vector3d::UnitX();
  down -= down.dot(along) * along;
  down = down.norm() > 1e-3 ? Eigen::Vector3d(down.normalized()) : along.unitOrthogonal();
  const Eigen::Vector3d side = along.cross(down);
  switch (bulge) {
    case Routing::Bulge::down:
      return down;
    case Routing::Bulge::up:
      return -down;
    case Routing::Bulge::left:
      return side;
    case Routing::Bulge::right:
      return -side;
    case Routing::Bulge::natural:
    case Routing::Bulge::stress_free:
      break;
  }
  return Eigen::Vector3d::Zero();
}

// The guide of one cable, anchor to anchor.
class CableGuide {
 public:
  CableGuide(const Harness& harness, const Topology& topology, std::size_t cable,
             const Configuration& configuration,
             const std::vector<std::optional<Eigen::Vector3d>>& meeting_points)
      : harness_(harness), cable_(cable), profile_(harness.cables[cable]) {
    for (std::size_t index : topology.cable_stations[cable]) {
      const Station& station = topology.stations[index];
      if (!holdsPosition(harness, station)) {
        if (!meeting_points[index]) continue;
        anchors_.push_back({configuration.stations[index].arc_length, *meeting_points[index], {}, {}});
        continue;
      }
      const Pose& pose = configuration.stations[index].pose;
      GuideAnchor anchor;
      anchor.arc_length = configuration.stations[index].arc_length;
      anchor.position = pose.position;
      if (holdsDirection(harness, station)) anchor.tangent = pose.orientation * Eigen::Vector3d::UnitX();
      if (holdsDirection(harness, station) && holdsRoll(harness, station))
        anchor.orientation = pose.orientation;
      anchors_.push_back(anchor);
    }
  }

  void build(const std::vector<Routing>& routing, std::size_t first_interval) {
    const Cable& cable = harness_.cables[cable_];
    if (anchors_.empty()) {  // not even a parent: somewhere, straight
      anchors_.push_back({0.0, Eigen::Vector3d::Zero(), Eigen::Vector3d(Eigen::Vector3d::UnitX()),
                          Eigen::Quaterniond(Eigen::Quaterniond::Identity())});
    }
    const std::size_t held = anchors_.size();
    const std::vector<GuideAnchor> held_anchors = anchors_;
    insertVia(cable.via);
    setTangents();
    const auto intervalOf = [&](double s) {
      std::size_t i = 0;
      while (i + 2 < held && held_anchors[i + 1].arc_length <= s) ++i;
      return i;
    };
    Eigen::Quaterniond orientation = startOrientation();
    std::vector<GuideCurve> pieces;
    for (std::size_t i = 0; i + 1 < anchors_.size(); ++i) {
      const GuideAnchor& a = anchors_[i];
      const GuideAnchor& b = anchors_[i + 1];
      const Routing route = routing[first_interval + intervalOf(0.5 * (a.arc_length + b.arc_length))];
      const Eigen::Vector3d chord = b.position - a.position;
      if (a.orientation) orientation = *a.orientation;
      if (route.bulge == Routing::Bulge::stress_free) {
        pieces.push_back(GuideCurve::freeBetween(profile_, a.arc_length, {a.position, orientation}, b));
        orientation = pieces.back().at(b.arc_length).orientation;
        continue;
      }
      GuideCurve piece = GuideCurve::between(a, b, bulgeDirection(route.bulge, chord, harness_.gravity),
                                             bulgeDirection(Routing::Bulge::down, chord, harness_.gravity));
      double twist = 0.0;
      if (b.orientation) {
        twist = piece.twistTo(orientation, *b.orientation);
        if (cable.twist) {
          const double wanted = *cable.twist * (b.arc_length - a.arc_length) / heldLength(held_anchors);
          twist += 2.0 * M_PI * std::round((wanted - twist) / (2.0 * M_PI));
        }
        twist += 2.0 * M_PI * route.turns;
      }
      piece.frame(orientation, twist);
      orientation = piece.at(b.arc_length).orientation;
      pieces.push_back(piece);
    }
    curves_.clear();
    const GuideAnchor& front = anchors_.front();
    const GuideAnchor& back = anchors_.back();
    if (front.arc_length > 0.0) {
      const Pose pose{front.position,
                      pieces.empty() ? orientation : pieces.front().at(front.arc_length).orientation};
      curves_.push_back(GuideCurve::free(profile_, front.arc_length, pose, -front.arc_length));
    }
    for (GuideCurve& piece : pieces) curves_.push_back(std::move(piece));
    if (back.arc_length < cable.length) {
      curves_.push_back(GuideCurve::free(profile_, back.arc_length, {back.position, orientation},
                                         cable.length - back.arc_length));
    }
  }

  Pose at(double arc_length) const {
    for (const GuideCurve& curve : curves_) {
      if (arc_length <= curve.end()) return curve.at(arc_length);
    }
    return curves_.back().at(arc_length);
  }

 private:
  static double heldLength(const std::vector<GuideAnchor>& anchors) {
    return anchors.back().arc_length - anchors.front().arc_length;
  }

  // Puts via points between the anchors where the detour is least; their arc
  // lengths share the piece by distance.
  void insertVia(const std::vector<Eigen::Vector3d>& via) {
    if (via.empty() || anchors_.size() < 2) return;
    std::vector<std::vector<Eigen::Vector3d>> between(anchors_.size() - 1);
    std::size_t earliest = 0;
    for (const Eigen::Vector3d& point : via) {
      double least = INFINITY;
      std::size_t best = earliest;
      for (std::size_t i = earliest; i + 1 < anchors_.size(); ++i) {
        const double detour = (point - anchors_[i].position).norm() +
                              (point - anchors_[i + 1].position).norm() -
                              (anchors_[i + 1].position - anchors_[i].position).norm();
        if (detour < least) {
          least = detour;
          best = i;
        }
      }
      between[best].push_back(point);
      earliest = best;
    }
    std::vector<GuideAnchor> all;
    for (std::size_t i = 0; i + 1 < anchors_.size(); ++i) {
      all.push_back(anchors_[i]);
      std::vector<Eigen::Vector3d> path{anchors_[i].position};
      path.insert(path.end(), between[i].begin(), between[i].end());
      path.push_back(anchors_[i + 1].position);
      double total = 0.0;
      for (std::size_t k = 1; k < path.size(); ++k) total += (path[k] - path[k - 1]).norm();
      double reached = 0.0;
      for (std::size_t k = 1; k + 1 < path.size(); ++k) {
        reached += (path[k] - path[k - 1]).norm();
        const double s =
            anchors_[i].arc_length + reached / total * (anchors_[i + 1].arc_length - anchors_[i].arc_length);
        all.push_back({s, path[k], {}, {}});
      }
    }
    all.push_back(anchors_.back());
    anchors_ = std::move(all);
  }

  // Where no tangent is held: from the previous anchor to the next.
  void setTangents() {
    if (anchors_.size() < 2) {
      if (!anchors_.front().tangent) anchors_.front().tangent = hangingDirection();
      return;
    }
    for (std::size_t i = 0; i < anchors_.size(); ++i) {
      if (anchors_[i].tangent) continue;
      const Eigen::Vector3d& before = anchors_[i == 0 ? 0 : i - 1].position;
      const Eigen::Vector3d& after = anchors_[std::min(i + 1, anchors_.size() - 1)].position;
      const Eigen::Vector3d chord = after - before;
      anchors_[i].tangent =
          chord.norm() > 0.0 ? Eigen::Vector3d(chord.normalized()) : Eigen::Vector3d::UnitX();
    }
  }

  // A cable on a single place that leaves its direction free hangs down from it.
  Eigen::Vector3d hangingDirection() const {
    const Eigen::Vector3d& g = harness_.gravity;
    return g.norm() > 0.0 ? Eigen::Vector3d(g.normalized()) : Eigen::Vector3d::UnitX();
  }

  Eigen::Quaterniond startOrientation() const {
    const GuideAnchor& front = anchors_.front();
    if (front.orientation) return *front.orientation;
    return so3::smallestRotation(Eigen::Vector3d::UnitX(), *front.tangent);
  }

  const Harness& harness_;
  std::size_t cable_;
  RodProfile profile_;
  std::vector<GuideAnchor> anchors_;
  std::vector<GuideCurve> curves_;
};

}  // namespace

bool InitialShape::isAnchor(std::size_t station) const {
  return holdsPosition(harness_, topology_.stations[station]) || meeting_points_[station].has_value();
}

InitialShape::InitialShape(const Harness& harness, const Topology& topology)
    : harness_(harness), topology_(topology), cable_order_(cablesParentsFirst(harness)) {
  Configuration clips;
  for (const Station& station : topology.stations) {
    StationConfiguration at;
    at.arc_length = station.arc_length;
    if (station.clip) at.pose = harness.clips[*station.clip].pose;
    clips.stations.push_back(at);
  }
  meeting_points_ = meetingPoints(harness, topology, clips);
  for (std::size_t c : cable_order_) {
    const Station* last = nullptr;
    for (std::size_t index : topology.cable_stations[c]) {
      const Station& station = topology.stations[index];
      if (!isAnchor(index)) continue;
      if (last != nullptr) {
        const Cable& cable = harness.cables[c];
        intervals_.push_back({c, last->arc_length, station.arc_length,
                              holdsRoll(harness, *last) && holdsRoll(harness, station),
                              !cable.via.empty() || cable.twist.has_value(), !cable.rest_curvature.empty()});
      }
      last = &station;
    }
  }
}

Configuration InitialShape::make(const Grid& grid, const std::vector<Routing>& routing,
                                 const std::vector<double>& arc_lengths) const {
  Configuration configuration;
  configuration.stations.resize(topology_.stations.size());
  configuration.spans.resize(topology_.spans.size());
  for (std::size_t i = 0; i < topology_.stations.size(); ++i) {
    StationConfiguration& at = configuration.stations[i];
    at.arc_length = arc_lengths.empty() ? topology_.stations[i].arc_length : arc_lengths[i];
    if (topology_.stations[i].clip) at.pose = harness_.clips[*topology_.stations[i].clip].pose;
  }
  std::size_t first_interval = 0;
  for (std::size_t c : cable_order_) {
    placeStations(harness_, topology_, configuration);
    CableGuide guide(harness_, topology_, c, configuration, meeting_points_);
    guide.build(routing, first_interval);
    first_interval += static_cast<std::size_t>(
        std::count_if(intervals_.begin(), intervals_.end(), [c](const Interval& i) { return i.cable == c; }));
    for (std::size_t index : topology_.cable_stations[c]) {
      const Station& station = topology_.stations[index];
      StationConfiguration& at = configuration.stations[index];
      const Pose pose = guide.at(at.arc_length);
      if (!holdsPosition(harness_, station)) at.pose.position = pose.position;
      if (!holdsDirection(harness_, station) && !holdsRoll(harness_, station))
        at.pose.orientation = pose.orientation;
      // a clip that lets the cable roll about x takes the guide's roll
      const bool rolls = station.clip && holdsDirection(harness_, station) && !holdsRoll(harness_, station);
      if (rolls) {
        const Eigen::Quaterniond relative =
            harness_.clips[*station.clip].pose.orientation.conjugate() * pose.orientation;
        at.rotation.x() = std::remainder(2.0 * std::atan2(relative.x(), relative.w()), 2.0 * M_PI);
      }
    }
    for (std::size_t index : topology_.cable_spans[c]) {
      const Span& span = topology_.spans[index];
      const double left = configuration.stations[span.left].arc_length;
      const double right = configuration.stations[span.right].arc_length;
      SpanConfiguration& nodes = configuration.spans[index];
      nodes.positions.clear();
      nodes.orientations.clear();
      for (std::size_t e = 0; e + 1 < grid[index].size(); ++e) {
        for (int a = e == 0 ? 0 : 1; a < element::kNodes; ++a) {
          const double fraction =
              grid[index][e] + element::kNodeAt[a] * (grid[index][e + 1] - grid[index][e]);
          const Pose pose = guide.at(left + fraction * (right - left));
          nodes.positions.push_back(pose.position);
          nodes.orientations.push_back(pose.orientation);
        }
      }
    }
    placeStations(harness_, topology_, configuration);
  }
  return configuration;
}

}  // namespace cable_variation
