#include <cable_variation/equilibrium/discretisation/contact_system.h>

#include <algorithm>
#include <cmath>

namespace cable_variation {

using Eigen::Vector3d;
using element::kNodeAt;
using element::kNodes;

namespace {

// Gaps larger than this share of the tube's radius press with no force that was known of them.
constexpr double kBand = 0.1;
// A place sees no further than this many radii; what is clear beyond is not looked for again until it has
// moved.
constexpr double kSight = 8.0;
// Places with the same multiplier see the part in directions whose cosine is more than this.
constexpr double kSameDirection = 0.5;

bool isNearer(const SurfacePlace& a, const SurfacePlace& b) { return a.distance < b.distance; }

}  // namespace

ContactSystem::ContactSystem(const Harness& harness, const Topology& topology, const Grid& grid)
    : harness_(harness), topology_(topology), spans_(topology.spans.size()) {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    spans_[i].grid = grid[i];
    for (std::size_t c = 0; c < harness.contacts.size(); ++c) {
      if (harness.contacts[c].cable == topology.spans[i].cable) spans_[i].contacts.push_back(c);
    }
  }
  harnessChanged();
  forget();
}

void ContactSystem::harnessChanged() {
  profiles_.clear();
  for (const Cable& cable : harness_.cables) profiles_.emplace_back(cable);
  double load = 0.0;  // of everything [N]
  for (const PointLoad& of : harness_.loads) load += of.force.norm();
  for (std::size_t c = 0; c < harness_.cables.size(); ++c) {
    const double length = harness_.cables[c].length;
    load += profiles_[c].at(0.5 * length).mass_per_length * length * harness_.gravity.norm();
  }
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    // This many times what bends the span's middle, or of a long one a stretch of as many radii: stiff enough
    // for a few rounds to find the forces, and soft enough for steps along a rounded part, which close or
    // open gaps by the square of their length, not to lose contact. Ten times more or less takes two to ten
    // times as many steps. What is taut rather than stiff resists as its load over as long a stretch does.
    constexpr double kOfBending = 1e3, kOfLoad = 1e2, kOfStretch = 1e2, kLongest = 50.0;
    const Span& span = topology_.spans[i];
    const double left = topology_.stations[span.left].arc_length;
    const double length = topology_.stations[span.right].arc_length - left;
    const RodProperties middle = profiles_[span.cable].at(left + 0.5 * length);
    double reach = middle.radius;
    for (const std::size_t c : spans_[i].contacts)
      reach = std::max(reach, middle.radius + harness_.contacts[c].stand_off);
    const double bent = std::min(length, kLongest * reach);
    const double bending = std::max(middle.stiffness[4], middle.stiffness[5]);
    spans_[i].stiffness = std::min(kOfBending * 48.0 * bending / (bent * bent * bent) + kOfLoad * load / bent,
                                   kOfStretch * middle.stiffness[0] / bent);
    for (Place& place : spans_[i].places) setNumbers(i, place);
  }
}

void ContactSystem::setNumbers(std::size_t index, Place& place) const {
  const SpanPlaces& of = spans_[index];
  const Span& span = topology_.spans[index];
  const double left = topology_.stations[span.left].arc_length;
  const double length = topology_.stations[span.right].arc_length - left;
  const auto radiusAt = [&](double share) { return profiles_[span.cable].at(left + share * length).radius; };
  constexpr double kStep = 1e-6;
  const double element = of.grid[place.element + 1] - of.grid[place.element];
  place.radius = radiusAt(place.share);
  const double before = std::max(place.share - kStep, of.grid[place.element] + 1e-9);
  const double after = std::min(place.share + kStep, of.grid[place.element + 1] - 1e-9);
  place.radius_slope = (radiusAt(after) - radiusAt(before)) / (after - before) * element;
  place.gap.assign(of.contacts.size(), INFINITY);
  place.clear.assign(of.contacts.size(), -1.0);
  place.seen.assign(of.contacts.size(), Vector3d::Zero());
}

ContactSystem::Place ContactSystem::makePlace(std::size_t index, double share, bool base) const {
  const std::vector<double>& grid = spans_[index].grid;
  const auto after = std::upper_bound(grid.begin() + 1, grid.end() - 1, share);
  Place place;
  place.element = static_cast<std::size_t>(after - grid.begin()) - 1;
  place.share = share;
  place.base = base;
  const double start = grid[place.element], end = grid[place.element + 1];
  place.at = std::clamp((share - start) / (end - start), 0.0, 1.0);
  for (std::size_t a = 0; a < kNodes; ++a) {
    double weight = 1.0, slope = 0.0;
    for (std::size_t b = 0; b < kNodes; ++b) {
      if (b == a) continue;
      weight *= (place.at - kNodeAt[b]) / (kNodeAt[a] - kNodeAt[b]);
      double product = 1.0 / (kNodeAt[a] - kNodeAt[b]);
      for (std::size_t c = 0; c < kNodes; ++c) {
        if (c != a && c != b) product *= (place.at - kNodeAt[c]) / (kNodeAt[a] - kNodeAt[c]);
      }
      slope += product;
    }
    place.weight[a] = weight;
    place.slope[a] = slope;
  }
  setNumbers(index, place);
  return place;
}

Vector3d ContactSystem::positionAt(const SpanConfiguration& span, const Place& place) {
  Vector3d x = Vector3d::Zero();
  for (std::size_t a = 0; a < kNodes; ++a) x += place.weight[a] * span.positions[3 * place.element + a];
  return x;
}

Vector3d ContactSystem::tangentAt(const SpanConfiguration& span, const Place& place) {
  Vector3d x = Vector3d::Zero();
  for (std::size_t a = 0; a < kNodes; ++a) x += place.slope[a] * span.positions[3 * place.element + a];
  return x;
}

double ContactSystem::arcLength(std::size_t index, double share, const Configuration& configuration) const {
  const double left = configuration.stations[topology_.spans[index].left].arc_length;
  const double right = configuration.stations[topology_.spans[index].right].arc_length;
  return left + share * (right - left);
}

std::vector<CableStretch> ContactSystem::skipped(const PartContact& contact,
                                                 const Configuration& configuration) const {
  std::vector<CableStretch> stretches;
  if (!(contact.skip_near_clips > 0.0)) return stretches;
  for (const std::size_t clip : contact.own_clips) {
    const std::size_t station = topology_.clip_station[clip];
    if (station == kNoStation || topology_.stations[station].cable != contact.cable) continue;
    const double at = configuration.stations[station].arc_length;
    stretches.push_back({at - contact.skip_near_clips, at + contact.skip_near_clips});
  }
  return stretches;
}

bool ContactSystem::counts(const std::vector<CableStretch>& skipped, double arc_length) {
  return std::none_of(skipped.begin(), skipped.end(), [&](const CableStretch& stretch) {
    return arc_length > stretch.start && arc_length < stretch.end;
  });
}

double ContactSystem::reach(std::size_t contact, const Place& place) const {
  return place.radius + harness_.contacts[contact].stand_off;
}

void ContactSystem::evaluate(const Configuration& configuration) {
  if (is_frozen_) {
    evaluateFrozen(configuration);
    return;
  }
  pressing_.clear();
  energy_ = worst_gap_ = 0.0;
  std::vector<SurfacePlace> found;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanPlaces& span = spans_[i];
    const double stiffness = softness_ * span.stiffness;
    moveMinima(i, configuration.spans[i]);
    for (std::size_t k = 0; k < span.contacts.size(); ++k) {
      const std::size_t c = span.contacts[k];
      const PartContact& contact = harness_.contacts[c];
      const std::vector<CableStretch> stretches = skipped(contact, configuration);
      const Pose into = contact.pose.inverse();
      for (Place& place : span.places) {
        place.fresh = false;
        place.gap[k] = INFINITY;
        for (Held& held : place.held) {
          if (held.contact == c) held.now = 0.0;
        }
        if (place.moves && place.held.front().contact != c) continue;
        if (!place.moves && has_points_ && isBesidePoint(i, c, place.share)) continue;
        if (!stretches.empty() && !counts(stretches, arcLength(i, place.share, configuration))) continue;
        const Vector3d x = into * positionAt(configuration.spans[i], place);
        const double reach = this->reach(c, place), near = (1.0 + kBand) * reach;
        if ((x - place.seen[k]).norm() < place.clear[k] - near) continue;
        place.seen[k] = x;
        found.clear();
        // what was near is likely to be so still
        if (place.clear[k] >= 0.0 && place.clear[k] < near) contact.surface->placesNear(x, near, found);
        if (found.empty()) {
          place.clear[k] = contact.surface->distance(x, kSight * reach);
          if (place.clear[k] >= near) continue;
          contact.surface->placesNear(x, near, found);
        } else {
          place.clear[k] = std::min_element(found.begin(), found.end(), isNearer)->distance;
        }
        std::vector<bool> taken(place.held.size(), false);
        for (const SurfacePlace& on : found) {
          std::size_t match = place.held.size();
          double best = kSameDirection;
          for (std::size_t h = 0; h < taken.size(); ++h) {
            if (taken[h] || place.held[h].contact != c) continue;
            const double cosine = place.held[h].direction.dot(on.direction);
            if (cosine > best) {
              best = cosine;
              match = h;
            }
          }
          if (place.moves && match == place.held.size()) continue;
          const double gap = on.distance - reach;
          place.gap[k] = std::min(place.gap[k], gap);
          const double known = match < place.held.size() ? place.held[match].known : 0.0;
          const double force = std::max(0.0, known - stiffness * gap);
          if (match < taken.size()) {
            taken[match] = true;
            place.held[match].now = force;
            place.held[match].direction = on.direction;
          } else if (force > 0.0) {
            place.held.push_back({c, on.direction, 0.0, force});
          }
          worst_gap_ = std::max(worst_gap_, force > 0.0 ? std::abs(gap) : -gap);
          if (force <= 0.0) continue;
          Pressing pressing;
          pressing.span = i;
          pressing.element = place.element;
          pressing.contact = c;
          pressing.weight = place.weight;
          pressing.share = place.share;
          pressing.place = static_cast<std::size_t>(&place - span.places.data());
          const double width = span.grid[place.element + 1] - span.grid[place.element];
          pressing.position = contact.pose * x;
          pressing.tangent = tangentAt(configuration.spans[i], place) / width;
          pressing.radius = place.radius;
          pressing.radius_slope = place.radius_slope / width;
          pressing.on_part = contact.pose * on.point;
          pressing.direction = contact.pose.orientation * on.direction;
          const Eigen::Matrix3d turn = contact.pose.orientation.toRotationMatrix();
          pressing.curvature = turn * on.curvature * turn.transpose();
          pressing.gap = gap;
          pressing.force = pressing.bent = force;
          pressing.stiffness = stiffness;
          if (place.sharpness > 0.0) {
            pressing.sharpness = place.sharpness / (width * width);
            pressing.along = pressing.curvature * pressing.tangent;
            setFollows(place, pressing);
          }
          pressing_.push_back(pressing);
        }
      }
    }
    for (const Place& place : span.places) {
      for (const Held& held : place.held)
        energy_ += 0.5 * (held.now * held.now - held.known * held.known) / stiffness;
    }
  }
}

void ContactSystem::freeze(const ContactSystem& other) {
  is_frozen_ = true;
  frozen_ = other.pressing_;
  for (Pressing& pressing : frozen_) {
    const Place place = makePlace(pressing.span, pressing.share, false);
    pressing.element = place.element;
    pressing.weight = place.weight;
    setFollows(place, pressing);
  }
}

void ContactSystem::evaluateFrozen(const Configuration& configuration) {
  pressing_ = frozen_;
  energy_ = 0.0;
  for (Pressing& pressing : pressing_) {
    Vector3d x = Vector3d::Zero();
    for (std::size_t a = 0; a < kNodes; ++a)
      x += pressing.weight[a] * configuration.spans[pressing.span].positions[3 * pressing.element + a];
    const double opened = pressing.direction.dot(x - pressing.position);
    energy_ += 0.5 * pressing.stiffness * opened * opened - pressing.force * opened;
    pressing.gap += opened;
    pressing.force -= pressing.stiffness * opened;
  }
}

bool ContactSystem::isClosed(std::size_t contact, std::size_t span, std::size_t place, double within) const {
  const SpanPlaces& of = spans_[span];
  for (std::size_t k = 0; k < of.contacts.size(); ++k) {
    if (of.contacts[k] != contact) continue;
    const Place& at = of.places[place];
    return (at.moves && at.held.front().contact != contact) || at.gap[k] <= within;
  }
  return false;
}

}  // namespace cable_variation
