// Electric wires that hang in a loop between two clamps, photographed five times each; measured data that may
// not be shipped.

#include <cmath>
#include <filesystem>

#include <cable_variation/identification/identification.h>

#include <identification/hanging_loop.h>

#include "figures.h"
#include "followed.h"
#include "validation.h"

namespace cable_variation::validation {
namespace {

struct WireData {
  const char* name;
  double mass_per_length;  ///< [kg/m]
  double target;           ///< of the repeats that had no part in the fit [m rms]
  double measured_twist;   ///< mean of five, at which the loop snaps [rad]
};

constexpr double kDegree = M_PI / 180.0;
const WireData kWires[] = {{"white", 0.087 / 5.0, 4e-3, 975.0 * kDegree},
                           {"black", 0.081 / 2.98, 8e-3, 482.0 * kDegree}};

std::vector<MeasuredShape> shapesOf(const std::string& folder, const std::string& wire) {
  std::vector<MeasuredShape> shapes;
  for (int i = 1; i <= 5; ++i) {
    MeasuredShape shape;
    shape.source = wire + "_" + std::to_string(i);
    shape.points = readMeasuredPoints((std::filesystem::path(folder) / (shape.source + ".csv")).string());
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

DesignValues fitted(const Scene& scene, const IdentificationTask& task, std::vector<Check>& checks) {
  const Identification found = identify(scene, task);
  DesignValues values;
  std::string text;
  for (std::size_t i = 0; i < task.variables.size(); ++i) {
    const DesignVariable& variable = scene.design_variables[task.variables[i]];
    values[variable.name] = found.values[i];
    text += (i > 0 ? ", " : "") + variable.name + " " + numberText(found.values[i], 4) +
            (found.determined[i] ? " ± " + numberText(found.deviations[static_cast<Eigen::Index>(i)], 2)
                                 : " (not told)");
  }
  std::string rms;
  for (const ShapeFit& fit : found.fits) rms += (rms.empty() ? "" : ", ") + numberText(1e3 * fit.rms, 3);
  checks.push_back({"two repeats fitted: " + text, "", "", rms + " mm rms", "the photographs fitted"});
  return values;
}

// The twist of one clamp at which the loop snaps, by the wire found: GJ is not told by shapes in a plane, it
// is that of a round bar of ν = 0.3.
double criticalTwist(Scene scene, DesignValues values) {
  DesignVariable twist;
  twist.name = "twist";
  twist.target = ClipRotation{1, Axis::x};
  DesignVariable torsion;
  torsion.name = "GJ";
  torsion.target = CableProperty{0, CableProperty::Property::GJ};
  torsion.nominal = scene.harness.cables[0].sections[0].section.GJ;
  scene.design_variables.push_back(twist);
  scene.design_variables.push_back(torsion);
  values["GJ"] = values.at("EI") / 1.3;
  return followedTo(
      [&](double angle) {
        values["twist"] = angle;
        return harnessAt(scene, values);
      },
      1e-3, 5.0 * kDegree, 40.0, 0.05);
}

void addWire(const WireData& data, const std::string& folder, std::vector<Check>& checks) {
  const std::vector<MeasuredShape> shapes = shapesOf(folder, data.name);
  test::Wire wire;
  wire.mass_per_length = data.mass_per_length;
  wire.across = shapes.front().points.back().x();
  const Scene scene = test::hangingLoop(wire, true);
  IdentificationTask task;
  for (const char* name : {"EI", "curl", "a_rz", "b_rz"}) {
    for (std::size_t i = 0; i < scene.design_variables.size(); ++i) {
      if (scene.design_variables[i].name == name) task.variables.push_back(i);
    }
  }
  task.shapes = {shapes[0], shapes[1]};
  const std::string who = std::string(data.name) + " wire: ";
  std::vector<Check> own;
  const DesignValues values = fitted(scene, task, own);
  for (Check& check : own) check.what = who + check.what;
  const std::vector<MeasuredShape> others(shapes.begin() + 2, shapes.end());
  const std::vector<ShapeFit> fits = compare(scene, values, others);
  for (std::size_t i = 0; i < fits.size(); ++i)
    own.push_back({who + "repeat " + std::to_string(i + 3) + ", which had no part in it",
                   "≤ " + numberText(1e3 * data.target, 3) + " mm rms aimed at", "",
                   numberText(1e3 * fits[i].rms, 3) + " mm rms", "photograph"});
  const double twist = criticalTwist(scene, values);
  own.push_back({who + "twist at which the loop snaps, predicted with GJ = EI/1.3",
                 numberText(data.measured_twist / kDegree, 4) + "°", numberText(twist / kDegree, 4) + "°",
                 shareOff(twist, data.measured_twist), "mean of five measured"});
  checks.insert(checks.end(), own.begin(), own.end());
}

}  // namespace

Chapter hangingWires(const std::string& folder) {
  Chapter chapter{"Hanging wires",
                  "Loops of 1.5 m of two electric wires between clamps 0.12 m apart "
                  "(github.com/qj25/adapteddlo_muj, MIT): "
                  "EI, a rest curvature that grows along the wire and the clamps' directions are found from "
                  "two repeats by "
                  "`identify`, and the other three are predicted. No parameter is tuned by hand.",
                  {},
                  ""};
  if (folder.empty() || !std::filesystem::exists(folder)) {
    chapter.left_out =
        "The photographs may not be shipped, and were not there: `scripts/validate --data FOLDER`.";
    return chapter;
  }
  for (const WireData& wire : kWires) addWire(wire, folder, chapter.checks);
  return chapter;
}

}  // namespace cable_variation::validation
