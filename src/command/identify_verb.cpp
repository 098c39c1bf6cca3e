#include <memory>
#include <utility>

#include <cable_variation/analysis/answer_files.h>
#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/identification/identification.h>
#include <cable_variation/report/csv.h>
#include <cable_variation/scene/design.h>
#include <cable_variation/util/count_text.h>
#include <cable_variation/util/display_unit.h>
#include <command/scene_options.h>
#include <command/text_table.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::DesignValues;
using cable_variation::DesignVariable;
using cable_variation::displayNumber;
using cable_variation::displayUnit;
using cable_variation::Identification;
using cable_variation::IdentificationTask;
using cable_variation::MeasuredShape;
using cable_variation::plain;
using cable_variation::ReportTable;
using cable_variation::Scene;
using cable_variation::ShapeFit;

namespace {

ReportTable valueTable(const Scene& scene, const IdentificationTask& task, const Identification& found) {
  ReportTable table{
      "Found from the points", {"variable", "unit", "nominal", "found", "standard deviation", ""}, {}};
  for (std::size_t i = 0; i < task.variables.size(); ++i) {
    const DesignVariable& variable = scene.design_variables[task.variables[i]];
    const double deviation = found.deviations[static_cast<Eigen::Index>(i)];
    const bool outside = found.values[i] < variable.nominal + variable.lower ||
                         found.values[i] > variable.nominal + variable.upper;
    const char* note = !found.determined[i] ? "the points do not tell: nominal"
                       : outside            ? "out of its tolerance"
                                            : "";
    table.rows.push_back({plain(variable.name), plain(displayUnit(variable.unit).symbol),
                          plain(displayNumber(variable.nominal, variable.unit)),
                          plain(displayNumber(found.values[i], variable.unit)),
                          plain(found.determined[i] ? displayNumber(deviation, variable.unit, 2) : "-"),
                          plain(note)});
  }
  return table;
}

ReportTable fitTable(const std::string& caption, const std::vector<MeasuredShape>& shapes,
                     const std::vector<ShapeFit>& fits) {
  ReportTable table{caption, {"points of", "points", "rms [mm]", "largest [mm]", "at point"}, {}};
  for (std::size_t i = 0; i < fits.size(); ++i) {
    table.rows.push_back({plain(shapes[i].source), plain(std::to_string(fits[i].distances.size())),
                          plain(displayNumber(fits[i].rms, "m", 3)),
                          plain(displayNumber(fits[i].largest, "m", 3)),
                          plain(std::to_string(fits[i].worst_point + 1))});
  }
  return table;
}

Json fitsJson(const std::vector<MeasuredShape>& shapes, const std::vector<ShapeFit>& fits) {
  Json list = Json::array();
  for (std::size_t i = 0; i < fits.size(); ++i) {
    Json fit = Json::object();
    fit.set("points", shapes[i].source).set("rms", fits[i].rms).set("largest", fits[i].largest);
    list.add(fit.set("worst_point", fits[i].worst_point).set("distances", fits[i].distances));
  }
  return list;
}

Json valuesJson(const Scene& scene, const IdentificationTask& task, const Identification& found) {
  Json list = Json::array();
  for (std::size_t i = 0; i < task.variables.size(); ++i) {
    const DesignVariable& variable = scene.design_variables[task.variables[i]];
    Json value = Json::object();
    value.set("variable", variable.name).set("unit", variable.unit).set("nominal", variable.nominal);
    value.set("value", found.values[i]).set("determined", bool(found.determined[i]));
    list.add(value.set("standard_deviation", found.deviations[static_cast<Eigen::Index>(i)]));
  }
  return list;
}

std::string distancesCsv(const std::vector<MeasuredShape>& shapes, const std::vector<ShapeFit>& fits,
                         const char* used) {
  std::string rows;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    for (std::size_t k = 0; k < fits[i].distances.size(); ++k) {
      const Eigen::Vector3d& point = shapes[i].points[k];
      rows += cable_variation::csv::text(shapes[i].source) + "," + used + "," + std::to_string(k + 1);
      for (int axis = 0; axis < 3; ++axis) rows += "," + cable_variation::csv::number(point[axis]);
      rows += "," + cable_variation::csv::number(fits[i].distances[k]) + "\r\n";
    }
  }
  return rows;
}

class IdentifyVerb : public Verb {
 public:
  void declare(Options& options) override {
    scene_.declare(options);
    options.texts("variables", "NAME", unknowns_, "design variables that are to be found");
    options.texts("points", "FILE", points_,
                  "measured points of the cable, in order from its start (CSV: x,y,z)");
    options.texts("compare", "FILE", compared_,
                  "likewise, of shapes that have no part in finding the values");
    options.text("cable", "NAME", cable_, "that was measured; default: the only one");
    values_.declare("nominal_variables", "nominal_values", options);
    options.text("name", "NAME", name_,
                 "write the scene with the values found as NAME.yaml, distances as NAME.csv");
    files_.declare(options);
  }

  Answer run(cable_variation::RunControl& control) override {
    if (unknowns_.empty()) throw UsageError("--variables: none is given, expected what is to be found");
    if (points_.empty()) throw UsageError("--points: none is given, expected one file of points or more");
    if (!name_.empty()) cable_variation::OutputDirectory::checkName(name_);
    const Scene scene = scene_.load(control);
    const DesignValues known = values_.values(scene);
    IdentificationTask task;
    for (const std::string& name : unknowns_)
      task.variables.push_back(cable_variation::indexOf(name, scene.design_variables, "design variable"));
    task.shapes = shapesOf(points_, scene, known);
    const std::vector<MeasuredShape> others = shapesOf(compared_, scene, known);
    task.check = [&control] { control.throwIfCancelled(); };
    const cable_variation::OutputDirectory output = files_.output();
    if (!name_.empty()) {
      output.requireWritable();
      std::vector<std::string> read{scene.source};
      for (const auto& files : {points_, compared_}) read.insert(read.end(), files.begin(), files.end());
      for (const char* extension : {".yaml", ".csv"}) keepInputs(read, output.pathOf(name_, extension));
    }

    control.report({"fitting"});
    const Identification found = identify(scene, task);
    DesignValues values = known;
    for (std::size_t i = 0; i < task.variables.size(); ++i)
      values[scene.design_variables[task.variables[i]].name] = found.values[i];
    const std::vector<ShapeFit> fits =
        others.empty() ? std::vector<ShapeFit>() : compare(scene, values, others);

    Answer answer;
    answer.json.set("values", valuesJson(scene, task, found)).set("correlation", rowByRow(found.correlation));
    answer.json.set("noise", found.noise).set("converged", found.converged).set("solves", found.solves);
    answer.json.set("fits", fitsJson(task.shapes, found.fits)).set("compared", fitsJson(others, fits));
    answer.text = tableText(valueTable(scene, task, found)) + "\n" +
                  tableText(fitTable("Distances of the points", task.shapes, found.fits));
    if (!others.empty())
      answer.text += "\n" + tableText(fitTable("Distances of points that had no part in it", others, fits));
    answer.text += "\n" + cable_variation::countText(found.solves, "equilibrium", "equilibria") + "\n";
    answer.warnings = warningsOf(scene);
    if (!found.converged) {
      answer.status = {cable_variation::StatusCode::not_converged,
                       "the search was still getting closer after " +
                           cable_variation::countText(found.solves, "equilibrium", "equilibria")};
    }
    control.complete();
    if (!name_.empty()) {
      cable_variation::Design design{scene, {}, {}};
      for (const auto& [name, value] : values) setNominal(design, name, value);
      const std::string table = "points,part,number,x [m],y [m],z [m],distance [m]\r\n" +
                                distancesCsv(task.shapes, found.fits, "fitted") +
                                distancesCsv(others, fits, "compared");
      write(output, ".yaml", scene_.edited(scene, sceneOf(design)), "scene_file", answer);
      write(output, ".csv", table, "distances_file", answer);
    }
    return answer;
  }

 private:
  std::vector<MeasuredShape> shapesOf(const std::vector<std::string>& files, const Scene& scene,
                                      const DesignValues& known) const {
    const auto& cables = scene.harness.cables;
    if (cable_.empty() && cables.size() > 1)
      throw UsageError("--cable: none is given, and the scene has " + std::to_string(cables.size()));
    const std::size_t cable = cable_.empty() ? 0 : cable_variation::indexOf(cable_, cables, "cable");
    std::vector<MeasuredShape> shapes;
    shapes.reserve(files.size());
    for (const std::string& file : files)
      shapes.push_back({file, cable, cable_variation::readMeasuredPoints(file), known});
    return shapes;
  }

  void write(const cable_variation::OutputDirectory& output, const char* extension,
             const std::string& content, const char* field, Answer& answer) const {
    const std::string path = writeBeside(output, name_, extension, content, answer.status.message);
    if (path.empty()) answer.status.code = cable_variation::StatusCode::io_error;
    if (!path.empty()) answer.text += path + "\n";
    answer.json.set(field, path);
  }

  SceneOption scene_;
  ValueOptions values_;
  FileOptions files_;
  std::vector<std::string> unknowns_, points_, compared_;
  std::string cable_, name_;
};

}  // namespace

std::unique_ptr<Verb> makeIdentify() { return std::make_unique<IdentifyVerb>(); }

}  // namespace cable_variation_command
