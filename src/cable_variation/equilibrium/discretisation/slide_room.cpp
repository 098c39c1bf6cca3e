#include <cable_variation/equilibrium/discretisation/slide_room.h>

#include <algorithm>

namespace cable_variation {

double leastLength(const Harness& harness, const Topology& topology, const Span& span) {
  constexpr double kShareOfRoom = 0.005, kShareOfOwn = 0.1;
  const auto slides = [&](std::size_t station) {
    const auto& clip = topology.stations[station].clip;
    return clip && harness.clips[*clip].constraint.slides;
  };
  if (!slides(span.left) && !slides(span.right)) return 0.0;
  const std::vector<std::size_t>& stations = topology.cable_stations[span.cable];
  auto first = std::find(stations.begin(), stations.end(), span.left);
  auto last = first + 1;
  while (first != stations.begin() && slides(*first)) --first;
  while (last + 1 != stations.end() && slides(*last)) ++last;
  const double room = topology.stations[*last].arc_length - topology.stations[*first].arc_length;
  const double own = topology.stations[span.right].arc_length - topology.stations[span.left].arc_length;
  return std::min(kShareOfRoom * room, kShareOfOwn * own);
}

}  // namespace cable_variation
