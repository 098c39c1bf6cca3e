#include <ros_interface/markers/simulation_markers.h>

#include <algorithm>
#include <cstdio>

#include <ros_interface/markers/cable_markers.h>
#include <ros_interface/markers/cable_tubes.h>
#include <ros_interface/markers/colour_map.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::CableVariation;
using cable_variation::KeptShape;
using cable_variation::SampleOutcome;
using cable_variation::Scene;
using cable_variation::SectionVariation;
using cable_variation::Simulation;

namespace {

constexpr double kThickness = 1.06;  // times the cable's, which it covers
constexpr double kSegment = 0.004;   // of one colour [m]
constexpr double kLine = 0.0004;     // width of a sample's centreline [m]
constexpr double kMillimetres = 1e3;
// Neither is red, which is for interference, nor in viridis.
const Eigen::Vector4d kSolvedColour(0.93, 0.95, 0.98, 0.30), kSnappedColour(1.0, 0.45, 0.85, 0.85);

double valueOf(const SectionVariation& section, VariationFigure figure) {
  return figure == VariationFigure::range ? section.range.maxCoeff() : 6.0 * section.axes.sigma[0];
}

/// At an arc length, linear between the sections.
double valueAt(const CableVariation& cable, VariationFigure figure, double s) {
  const std::vector<double>& arc = cable.arc_length;
  const auto above = std::upper_bound(arc.begin(), arc.end(), s);
  if (above == arc.begin()) return valueOf(cable.sections.front(), figure);
  if (above == arc.end()) return valueOf(cable.sections.back(), figure);
  const auto i = static_cast<std::size_t>(above - arc.begin());
  const double share = (s - arc[i - 1]) / (arc[i] - arc[i - 1]);
  return (1.0 - share) * valueOf(cable.sections[i - 1], figure) + share * valueOf(cable.sections[i], figure);
}

double largestOf(const Simulation& simulation, VariationFigure figure) {
  double largest = 0.0;
  for (const CableVariation& cable : simulation.cables) {
    for (const SectionVariation& section : cable.sections) {
      largest = std::max(largest, valueOf(section, figure));
    }
  }
  return largest;
}

void append(const MarkerGroup& group, visualization_msgs::MarkerArray& array) {
  array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
}

/// The centrelines of all samples kept: those that solved have id 0, those that snapped id 1.
void addShapes(const Simulation& simulation, std::size_t cable, MarkerGroup& group) {
  for (const SampleOutcome outcome : {SampleOutcome::solved, SampleOutcome::snapped}) {
    std::vector<Eigen::Vector3d> ends;
    for (const KeptShape& shape : simulation.shapes) {
      if (shape.outcome != outcome) continue;
      const Eigen::Matrix3Xd& line = shape.cables[cable];
      for (Eigen::Index i = 1; i < line.cols(); ++i) {
        ends.emplace_back(line.col(i - 1));
        ends.emplace_back(line.col(i));
      }
    }
    group.setColor(outcome == SampleOutcome::solved ? kSolvedColour : kSnappedColour);
    group.addLines(ends, kLine);
  }
}

std::string noteOf(const Simulation& simulation, bool over_motion) {
  std::string note;
  const auto add = [&](const char* format, auto... values) {
    char text[96];
    std::snprintf(text, sizeof text, format, values...);
    note += (note.empty() ? "" : "; ") + std::string(text);
  };
  if (over_motion) add("at t = %.3g s", simulation.shown_time);
  if (!simulation.shapes.empty()) add("lines: %zu of the samples", simulation.shapes.size());
  const auto count = [&](SampleOutcome outcome) {
    return static_cast<unsigned long long>(simulation.statistics.count(outcome));
  };
  if (count(SampleOutcome::snapped) > 0) {
    add("%llu snapped to another equilibrium%s", count(SampleOutcome::snapped),
        simulation.shapes.empty() ? "" : " (pink lines)");
  }
  const auto without = count(SampleOutcome::not_converged) + count(SampleOutcome::impossible);
  if (without > 0) add("%llu more without an equilibrium", without);
  return note;
}

}  // namespace

SimulationView simulationView(const Scene& scene, const Simulation& simulation, VariationFigure figure,
                              bool over_motion) {
  const double largest = largestOf(simulation, figure);
  const ColourScale colours(0.0, largest);
  SimulationView view;
  for (const CableVariation& cable : simulation.cables) {
    const std::string& name = scene.harness.cables[cable.cable].name;
    MarkerGroup group(kVariationMarkers + name, kWorldFrame, Eigen::Vector4d::Ones());
    const auto color = [&](double s) {
      Eigen::Vector4d rgba = Eigen::Vector4d::Ones();
      rgba.head<3>() = colours(valueAt(cable, figure, s));
      return rgba;
    };
    addCable(group, simulation.linear.nominal.shapes[cable.cable], simulation.harness.cables[cable.cable],
             {kThickness, kSegment, color});
    append(group, view.markers);
    MarkerGroup lines(kVariationShapeMarkers + name, kWorldFrame, kSolvedColour);
    addShapes(simulation, cable.cable, lines);
    append(lines, view.markers);
  }

  const auto& statistics = simulation.statistics;
  view.legend.title = "Variation in production";
  view.legend.quantity = figure == VariationFigure::range ? "range in the direction that ranges most"
                                                          : "6 sigma in the direction that varies most";
  view.legend.unit = "mm";
  view.legend.maximum = kMillimetres * largest;
  view.legend.samples = static_cast<std::uint32_t>(statistics.count(SampleOutcome::solved) +
                                                   statistics.count(SampleOutcome::snapped));
  view.legend.note = noteOf(simulation, over_motion);
  std::map<std::size_t, std::function<double(double)>> values;
  for (const CableVariation& cable : simulation.cables) {
    values[cable.cable] = [&cable, figure](double s) { return kMillimetres * valueAt(cable, figure, s); };
  }
  view.tubes =
      valuedTubes(simulation.linear.nominal, simulation.harness, variationQuantity(view.legend), values);
  return view;
}

}  // namespace cable_variation_ros
