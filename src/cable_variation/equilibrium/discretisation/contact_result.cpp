#include <cable_variation/equilibrium/discretisation/contact_result.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

namespace cable_variation {
namespace {

std::vector<TubePiece> tubeOf(const Cable& cable, const CableShape& shape) {
  constexpr double kInside = 1e-9;  // of the length: the piece's side of a step
  const RodProfile profile(cable);
  std::vector<TubePiece> tube;
  for (std::size_t i = 0; i + 1 < shape.points.size(); ++i) {
    const ShapePoint &a = shape.points[i], &b = shape.points[i + 1];
    const double length = b.arc_length - a.arc_length;
    if (!(length > 0.0)) continue;
    tube.push_back({curveBetween(a, b), a.arc_length, b.arc_length,
                    profile.at(a.arc_length + kInside * length).radius,
                    profile.at(b.arc_length - kInside * length).radius});
  }
  return tube;
}

}  // namespace

std::vector<ContactInterval> describeContacts(const Harness& harness, const Topology& topology,
                                              const ContactSystem& system, const Configuration& configuration,
                                              double accuracy) {
  struct Touch {
    std::size_t cable, contact, span, place;
    ContactForce force;
  };
  // Whether the cable touches all the way between two places: it does so at all that are looked at.
  const auto areOne = [&](const Touch& a, const Touch& b) {
    if (a.cable != b.cable || a.contact != b.contact) return false;
    if (a.span != b.span) return false;
    for (std::size_t place = a.place + 1; place < b.place; ++place) {
      if (!system.isClosed(a.contact, a.span, place, std::max(accuracy, kTouching))) return false;
    }
    return true;
  };
  std::vector<Touch> touches;
  for (const ContactSystem::Pressing& pressing : system.pressing()) {
    const Span& span = topology.spans[pressing.span];
    const double left = configuration.stations[span.left].arc_length;
    const double right = configuration.stations[span.right].arc_length;
    Touch touch{span.cable, pressing.contact, pressing.span, pressing.place, {}};
    touch.force.arc_length = left + pressing.share * (right - left);
    touch.force.on_part = pressing.on_part;
    touch.force.direction = pressing.direction;
    touch.force.force = pressing.force;
    touches.push_back(touch);
  }
  std::stable_sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) {
    return std::make_tuple(a.cable, a.contact, a.force.arc_length) <
           std::make_tuple(b.cable, b.contact, b.force.arc_length);
  });
  std::vector<ContactInterval> intervals;
  const Touch* last = nullptr;
  for (const Touch& touch : touches) {
    const ContactForce& at = touch.force;
    if (last == nullptr || !areOne(*last, touch)) {
      intervals.emplace_back();
      intervals.back().cable = touch.cable;
      intervals.back().contact = touch.contact;
      intervals.back().part = harness.contacts[touch.contact].part;
      intervals.back().start = at.arc_length;
    }
    ContactInterval& interval = intervals.back();
    const Eigen::Vector3d force = at.force * at.direction;
    interval.end = at.arc_length;
    last = &touch;
    interval.force += force;
    interval.moment += at.on_part.cross(force);
    interval.total += at.force;
    interval.places.push_back(at);
  }
  std::stable_sort(intervals.begin(), intervals.end(),
                   [](const ContactInterval& a, const ContactInterval& b) {
                     return std::make_pair(a.cable, a.start) < std::make_pair(b.cable, b.start);
                   });
  return intervals;
}

std::string heldInside(const Harness& harness) {
  if (harness.contacts.empty()) return {};
  validate(harness);
  const auto holds = [](const Clip& clip) {
    return clip.attached &&
           std::all_of(clip.constraint.translation.begin(), clip.constraint.translation.end(),
                       [](const ClipFreedom& freedom) { return freedom.kind == ClipFreedom::Kind::locked; });
  };
  for (const PartContact& contact : harness.contacts) {
    const Cable& cable = harness.cables[contact.cable];
    const auto skipped = [&](double arc_length) {
      return std::any_of(contact.own_clips.begin(), contact.own_clips.end(), [&](std::size_t clip) {
        return std::abs(harness.clips[clip].arc_length - arc_length) < contact.skip_near_clips;
      });
    };
    for (const Clip& clip : harness.clips) {
      if (clip.cable != contact.cable || !holds(clip) || skipped(clip.arc_length)) continue;
      const double reach = sectionAt(cable, clip.arc_length).radius + contact.stand_off;
      const double distance = contact.surface->distance(contact.pose.inverse() * clip.pose.position, reach);
      if (distance >= reach - kTouching) continue;
      std::ostringstream text;
      text << "clip '" << clip.name << "' holds cable '" << cable.name << "' with its centreline "
           << 1e3 * distance << " mm from part '" << contact.part << "', which it has contact with; expected "
           << 1e3 * reach << " mm or more, or skip_near_clips for what lies in its holder";
      return text.str();
    }
  }
  return {};
}

std::string passesThrough(const Harness& harness, std::size_t contact) {
  const PartContact& of = harness.contacts[contact];
  return "every start passes through part '" + of.part + "', the first of them with cable '" +
         harness.cables[of.cable].name +
         "'; expected via points that lead it outside, or skip_near_clips for what lies in its holder";
}

ExactGap exactGap(const Harness& harness, const ContactSystem& system, const Configuration& configuration,
                  const std::vector<CableShape>& shapes) {
  ExactGap smallest{std::numeric_limits<double>::infinity(), 0, 0.0};
  for (std::size_t c = 0; c < harness.contacts.size(); ++c) {
    const PartContact& contact = harness.contacts[c];
    const TubeGap gap =
        contact.surface->smallestGap(tubeOf(harness.cables[contact.cable], shapes[contact.cable]),
                                     contact.pose, system.skipped(contact, configuration));
    if (gap.gap - contact.stand_off < smallest.gap)
      smallest = {gap.gap - contact.stand_off, c, gap.arc_length};
  }
  return smallest;
}

}  // namespace cable_variation
