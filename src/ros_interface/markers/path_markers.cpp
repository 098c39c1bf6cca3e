#include <ros_interface/markers/path_markers.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <cable_variation/util/quantity.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/markers/colour_map.h>
#include <ros_interface/markers/label_placing.h>
#include <ros_interface/markers/marker_colours.h>
#include <ros_interface/markers/marker_shapes.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::PathCheck;
using cable_variation::PathSample;
using cable_variation::Scene;
using cable_variation::ShapeEvent;
using cable_variation::TimedEvent;
using Eigen::Vector3d;

namespace {

constexpr std::size_t kMostShapes = 40;
constexpr double kLine = 0.0008, kBall = 0.004, kText = 0.012, kAbove = 0.015;  // [m]
const Eigen::Vector4d kWayColour(0.9, 0.9, 0.95, 0.8), kWords(0.96, 0.97, 0.98, 1.0);

void append(const MarkerGroup& group, visualization_msgs::MarkerArray& array) {
  array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
}

std::vector<Vector3d> segments(const std::vector<Vector3d>& line) {
  std::vector<Vector3d> ends;
  for (std::size_t i = 1; i < line.size(); ++i) {
    ends.push_back(line[i - 1]);
    ends.push_back(line[i]);
  }
  return ends;
}

/// Some samples, the first and the last among them.
std::vector<std::size_t> shownSamples(std::size_t count) {
  const std::size_t shown = std::min(count, kMostShapes);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < shown; ++i) indices.push_back(shown < 2 ? 0 : i * (count - 1) / (shown - 1));
  return indices;
}

/// The last sample up to a time that has a shape.
const PathSample* shapeAt(const PathCheck& check, double time) {
  const PathSample* found = nullptr;
  for (const PathSample& sample : check.samples) {
    if (!sample.solved) continue;
    if (found != nullptr && sample.time > time) break;
    found = &sample;
  }
  return found;
}

template <typename Named>
std::optional<std::size_t> find(const std::vector<Named>& all, const std::string& name) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return i;
  }
  return std::nullopt;
}

/// Where an event is to be seen; nothing: nowhere.
std::optional<Vector3d> placeOf(const Scene& scene, const PathCheck& check, const TimedEvent& timed) {
  const PathSample* sample = shapeAt(check, timed.time);
  if (sample == nullptr) return std::nullopt;
  const ShapeEvent& event = timed.event;
  if (const auto clip = find(scene.harness.clips, event.clip))
    return sample->reactions[*clip].section.position;
  if (const auto measure = find(scene.measures, event.measure)) {
    const cable_variation::MeasureValue& value = sample->measures[*measure];
    if (value.has_place) return value.point;
  }
  const std::size_t cable = find(scene.harness.cables, event.cable).value_or(0);
  const std::vector<Vector3d>& line = sample->centrelines[cable];
  const double last = static_cast<double>(line.size() - 1);
  const double at =
      event.cable.empty() ? 0.5 * last : last * event.arc_length / scene.harness.cables[cable].length;
  return line[static_cast<std::size_t>(std::clamp(std::round(at), 0.0, last))];
}

std::string wordsOf(const TimedEvent& event) {
  return cable_variation::shortNumber(event.time) + " s: " + shortText(event.event);
}

MarkerGroup eventMarkers(const Scene& scene, const PathCheck& check) {
  MarkerGroup group("path/events", kWorldFrame, kWords);
  LabelPlacing labels;
  for (const TimedEvent& event : check.events) {
    const std::optional<Vector3d> place = placeOf(scene, check, event);
    if (!place) continue;
    group.setColor(isFault(event.event.kind) ? kInterferenceRed : kWords);
    group.addSphere(*place, kBall);
    group.setColor(kWords);
    const std::string words = wordsOf(event);
    group.addText(labels.place(*place + kAbove * Vector3d::UnitZ(), words, kText), words, kText);
  }
  return group;
}

}  // namespace

visualization_msgs::MarkerArray pathMarkers(const Scene& scene, const PathCheck& check,
                                            const cable_variation::ComponentPath& path) {
  visualization_msgs::MarkerArray array;
  const double first = check.samples.front().time, last = check.samples.back().time;
  for (std::size_t cable = 0; cable < scene.harness.cables.size(); ++cable) {
    MarkerGroup group("path/" + scene.harness.cables[cable].name, kWorldFrame, kWords);
    for (const std::size_t index : shownSamples(check.samples.size())) {
      const PathSample& sample = check.samples[index];
      if (!sample.solved) continue;
      const Vector3d colour = viridis((sample.time - first) / (last - first));
      group.setColor({colour.x(), colour.y(), colour.z(), 1.0});
      group.addLines(segments(sample.centrelines[cable]), kLine);
    }
    append(group, array);
  }
  if (path.frame) {
    std::vector<Vector3d> way;
    for (const PathSample& sample : check.samples) way.push_back(path.frame(sample.time).position);
    MarkerGroup group("path/way", kWorldFrame, kWayColour);
    group.addLines(segments(way), kLine);
    append(group, array);
  }
  append(eventMarkers(scene, check), array);
  return array;
}

std::vector<cable_variation::Label> pathLabels(const Scene& scene, const PathCheck& check) {
  std::vector<cable_variation::Label> labels;
  for (const TimedEvent& event : check.events) {
    const std::optional<Vector3d> place = placeOf(scene, check, event);
    if (!place) continue;
    cable_variation::Label label;
    label.kind = isFault(event.event.kind) ? cable_variation::Label::FAULT : cable_variation::Label::FIGURE;
    label.text = wordsOf(event);
    label.at = toPoint(*place);
    labels.push_back(label);
  }
  return labels;
}

}  // namespace cable_variation_ros
