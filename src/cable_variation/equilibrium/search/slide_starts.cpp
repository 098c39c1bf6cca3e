#include <cable_variation/equilibrium/search/slide_starts.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace cable_variation {
namespace {

constexpr double kLoose = 1.05;        // of the distance: length of a piece without slack
constexpr double kLeastPiece = 0.03;   // of the room, between neighbouring stations
constexpr double kNothingHeld = 0.25;  // of the room left on the side that no clip holds

enum class Slack { shared, behind, before, between };

class Rooms {
 public:
  Rooms(const Harness& harness, const Topology& topology) : harness_(harness), topology_(topology) {}

  std::vector<double> start(Slack slack) const {
    std::vector<double> arc_lengths;
    for (const Station& station : topology_.stations) arc_lengths.push_back(station.arc_length);
    for (const std::vector<std::size_t>& stations : topology_.cable_stations) {
      std::size_t left = 0;
      for (std::size_t i = 1; i < stations.size(); ++i) {
        if (slides(stations[i]) && i + 1 < stations.size()) continue;
        if (i > left + 1 || slides(stations[i])) place(stations, left, i, slack, arc_lengths);
        left = i;
      }
    }
    return arc_lengths;
  }

 private:
  bool slides(std::size_t station) const {
    const auto& clip = topology_.stations[station].clip;
    return clip && harness_.clips[*clip].constraint.slides;
  }

  std::optional<Eigen::Vector3d> held(std::size_t station) const {
    const auto& clip = topology_.stations[station].clip;
    if (!clip || !harness_.clips[*clip].constraint.holdsPosition()) return std::nullopt;
    return harness_.clips[*clip].pose.position;
  }

  // The sliding stations strictly between `left` and `right` of a cable.
  void place(const std::vector<std::size_t>& stations, std::size_t left, std::size_t right, Slack slack,
             std::vector<double>& arc_lengths) const {
    const double start = topology_.stations[stations[left]].arc_length;
    const double room = topology_.stations[stations[right]].arc_length - start;
    std::vector<double> reached{0.0};  // distance from the left end along the clips, where it is held
    for (std::size_t i = left + 1; i <= right; ++i) {
      const auto a = held(stations[i - 1]), b = held(stations[i]);
      reached.push_back(reached.back() + (a && b ? (*b - *a).norm() : kNothingHeld * room));
    }
    const double total = std::max(reached.back(), 1e-9);
    const double least = kLeastPiece * room;
    double before = 0.0;
    for (std::size_t i = left + 1; i < right; ++i) {
      const double way = reached[i - left];
      double at = room * way / total;
      const bool in_first_half = 2 * (i - left) <= right - left;
      if (slack == Slack::behind || (slack == Slack::between && in_first_half)) {
        at = std::min(at, kLoose * way);
      } else if (slack != Slack::shared) {
        at = std::max(at, room - kLoose * (total - way));
      }
      const double latest = room - static_cast<double>(right - i) * least;
      before = std::clamp(at, before + least, std::max(before + least, latest));
      arc_lengths[stations[i]] = start + before;
    }
  }

  const Harness& harness_;
  const Topology& topology_;
};

}  // namespace

std::vector<std::vector<double>> slideStarts(const Harness& harness, const Topology& topology) {
  const bool any = std::any_of(harness.clips.begin(), harness.clips.end(),
                               [](const Clip& clip) { return clip.attached && clip.constraint.slides; });
  if (!any) return {};
  const Rooms rooms(harness, topology);
  std::vector<std::vector<double>> starts;
  for (const Slack slack : {Slack::shared, Slack::behind, Slack::before, Slack::between}) {
    std::vector<double> start = rooms.start(slack);
    if (std::find(starts.begin(), starts.end(), start) == starts.end()) starts.push_back(std::move(start));
  }
  return starts;
}

}  // namespace cable_variation
