#include <cable_variation/geometry/body/body_distance.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <unordered_map>

#include <cable_variation/geometry/body/body_search.h>
#include <cable_variation/geometry/body/placed_body.h>
#include <cable_variation/geometry/tube_distance/triangle_pair.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

// The core of `other` enters that of `body` at `deepest`.
BodyPair fromDepth(const PlacedBody& body, const PlacedBody& other, const PlacedBody::Height& deepest) {
  BodyPair result;
  const Vector3d normal = body.normal(deepest.facet);
  result.distance = deepest.height - body.radius() - other.radius();
  result.on_body = deepest.point + (body.radius() - deepest.height) * normal;
  result.on_other = deepest.point - other.radius() * normal;
  result.facet = deepest.facet;
  result.triangle = other.height(deepest.point).facet;
  return result;
}

BodyPair swapped(BodyPair pair) {
  std::swap(pair.on_body, pair.on_other);
  std::swap(pair.facet, pair.triangle);
  return pair;
}

// Up to `cutoff`.
std::optional<BodyPair> closestPlaces(const PlacedBody& first, const PlacedBody& second, double cutoff) {
  constexpr double kNoDirection = 1e-13;  // [m]
  const double radii = first.radius() + second.radius();
  std::optional<BodyPair> closest;
  if (squaredGap(first.box(), second.box()) == 0.0) {
    const PlacedBody::Height in_first = first.lowest(second);
    if (in_first.height - radii > cutoff) return std::nullopt;
    if (in_first.height < 0.0) {
      const PlacedBody::Height in_second = second.lowest(first);
      closest = in_second.height < in_first.height ? swapped(fromDepth(second, first, in_second))
                                                   : fromDepth(first, second, in_first);
      if (closest->distance > cutoff) closest.reset();
      return closest;
    }
  }
  if (cutoff + radii < 0.0) return std::nullopt;
  const auto pair = closestPoints(first.facets(), second.facets(), cutoff + radii);
  if (!pair) return std::nullopt;
  closest = BodyPair();
  closest->facet = first.facets().number[pair->first];
  closest->triangle = second.facets().number[pair->second];
  closest->distance = pair->distance - radii;
  const Vector3d direction = pair->distance > kNoDirection
                                 ? Vector3d((pair->on_second - pair->on_first) / pair->distance)
                                 : first.normal(closest->facet);
  closest->on_body = pair->on_first + first.radius() * direction;
  closest->on_other = pair->on_second - second.radius() * direction;
  return closest;
}

}  // namespace

std::optional<BodyPair> distance(const std::vector<BodyCouple>& couples) {
  std::deque<PlacedBody> placed;
  std::unordered_map<const RoundedHull*, const PlacedBody*> ready;
  const auto ready_one = [&](const RoundedHull* body) {
    const PlacedBody*& known = ready[body];
    if (known == nullptr) known = &placed.emplace_back(*body, Pose());
    return known;
  };
  std::vector<std::pair<const PlacedBody*, const PlacedBody*>> bodies;
  std::vector<Candidate> candidates;
  bodies.reserve(couples.size());
  candidates.reserve(couples.size());
  for (std::size_t i = 0; i < couples.size(); ++i) {
    const PlacedBody *first = ready_one(couples[i].first), *second = ready_one(couples[i].second);
    bodies.emplace_back(first, second);
    const double radii = first->radius() + second->radius();
    const double gap = std::sqrt(squaredGap(first->box(), second->box()));
    const double key = (first->centre() - second->centre()).norm() - first->reach() - second->reach();
    candidates.push_back(
        {i, key - radii, (gap > 0.0 ? gap : -std::max(first->reach(), second->reach())) - radii});
  }
  return closestOf(std::move(candidates), [&](std::size_t i, double cutoff) {
    return closestPlaces(*bodies[i].first, *bodies[i].second, cutoff);
  });
}

}  // namespace cable_variation
