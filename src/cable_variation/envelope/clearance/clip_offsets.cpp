#include <cable_variation/envelope/clearance/clip_offsets.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cable_variation {

ClipOffsets::ClipOffsets(const SampleSpace& space, const SamplePlace& start, const Equilibrium& equilibrium)
    : design_(space.harness(start)), topology_(makeTopology(design_)) {
  nominal_ = arcLengths(design_, &equilibrium);
  const auto stations = [&](std::size_t clip) -> const std::vector<std::size_t>& {
    return topology_.cable_stations[design_.clips[clip].cable];
  };
  const auto offset = [&](const std::vector<double>& arc_lengths, std::size_t clip, std::size_t station) {
    return arc_lengths[station] - arc_lengths[topology_.clip_station[clip]];
  };
  ranges_.resize(design_.clips.size());
  for (std::size_t clip = 0; clip < ranges_.size(); ++clip) {
    if (topology_.clip_station[clip] == kNoStation) continue;
    for (const std::size_t station : stations(clip)) {
      const double at = offset(nominal_, clip, station);
      ranges_[clip].push_back({at, at});
    }
  }
  const std::vector<double> unsolved = arcLengths(design_, nullptr);
  for (Eigen::Index variable = 0; variable < space.tolerances().size(); ++variable) {
    std::vector<std::vector<double>> extremes;
    for (const double deviation :
         {space.tolerances().lower()[variable], space.tolerances().upper()[variable]}) {
      SamplePlace place = start;
      place.deviations[variable] = deviation;
      extremes.push_back(arcLengths(space.harness(place), nullptr));
      comparable_ = comparable_ && !extremes.back().empty();
    }
    if (!comparable_) return;
    for (std::size_t clip = 0; clip < ranges_.size(); ++clip) {
      for (std::size_t k = 0; k < ranges_[clip].size(); ++k) {
        const std::size_t station = stations(clip)[k];
        const double before = offset(unsolved, clip, station);
        const double one = offset(extremes[0], clip, station) - before;
        const double other = offset(extremes[1], clip, station) - before;
        ranges_[clip][k].low += std::min({0.0, one, other});
        ranges_[clip][k].high += std::max({0.0, one, other});
      }
    }
  }
}

// Per station [m]; where clips start to slide from, if no equilibrium is given.
std::vector<double> ClipOffsets::arcLengths(const Harness& harness, const Equilibrium* equilibrium) const {
  auto found = stationArcLengths(design_, topology_, harness);
  if (!found) return {};
  for (std::size_t clip = 0; equilibrium != nullptr && clip < harness.clips.size(); ++clip) {
    if (topology_.clip_station[clip] != kNoStation)
      (*found)[topology_.clip_station[clip]] = equilibrium->clip_reactions[clip].arc_length;
  }
  return *std::move(found);
}

void ClipOffsets::add(const Harness& harness, const Equilibrium& equilibrium) {
  const std::vector<double> arc_lengths = arcLengths(harness, &equilibrium);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (arc_lengths.empty()) {
    comparable_ = false;
    return;
  }
  for (std::size_t clip = 0; clip < ranges_.size(); ++clip) {
    for (std::size_t k = 0; k < ranges_[clip].size(); ++k) {
      const std::size_t station = topology_.cable_stations[design_.clips[clip].cable][k];
      const double at = arc_lengths[station] - arc_lengths[topology_.clip_station[clip]];
      ranges_[clip][k].low = std::min(ranges_[clip][k].low, at);
      ranges_[clip][k].high = std::max(ranges_[clip][k].high, at);
    }
  }
}

double ClipOffsets::largest(std::size_t clip, double nominal) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!comparable_ || ranges_[clip].empty()) return std::numeric_limits<double>::infinity();
  const std::vector<std::size_t>& stations = topology_.cable_stations[design_.clips[clip].cable];
  std::size_t k = 1;
  while (k + 1 < stations.size() && nominal_[stations[k]] < nominal) ++k;
  const double before = nominal_[stations[k - 1]], length = nominal_[stations[k]] - before;
  const double share = std::clamp((nominal - before) / length, 0.0, 1.0);
  const Range &from = ranges_[clip][k - 1], &to = ranges_[clip][k];
  return std::max(std::abs(from.low + share * (to.low - from.low)),
                  std::abs(from.high + share * (to.high - from.high)));
}

std::vector<double> ClipOffsets::placesWithin(std::size_t clip, double near) const {
  std::vector<double> places;
  if (ranges_[clip].empty()) return places;
  const std::vector<std::size_t>& stations = topology_.cable_stations[design_.clips[clip].cable];
  const double held = nominal_[topology_.clip_station[clip]];
  for (const double end : {nominal_[stations.front()], nominal_[stations.back()]}) {
    if (!(largest(clip, end) > near)) continue;
    // The way grows with the distance from the clip, or is too large everywhere.
    double within = held, beyond = end;
    if (!(largest(clip, within) <= near)) continue;
    for (double middle = 0.5 * (within + beyond); middle != within && middle != beyond;
         middle = 0.5 * (within + beyond)) {
      (largest(clip, middle) <= near ? within : beyond) = middle;
    }
    places.push_back(within);
  }
  return places;
}

}  // namespace cable_variation
