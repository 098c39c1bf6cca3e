#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include <cable_variation/analysis/answer_files.h>
#include <cable_variation/analysis/design_trial.h>
#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/report/route_table.h>
#include <cable_variation/report/shape_file/shape_file.h>
#include <cable_variation/util/chosen_indices.h>
#include <command/scene_options.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::ComponentPoses;
using cable_variation::DesignTrial;
using cable_variation::DesignValues;
using cable_variation::Scene;
using cable_variation::SolvedScene;

namespace {

/// What there is to write.
struct Shapes {
  const Scene& scene;
  const SolvedScene& solved;
  const std::vector<std::size_t>& cables;
  double step;
};

/// A kind of file.
struct Format {
  const char* name;
  const char* ending;  ///< behind the name of all files
  std::string (*content)(const Shapes& shapes);
};

template <std::string (*content)(const SolvedScene&, const std::vector<std::size_t>&, double)>
std::string ofShapes(const Shapes& shapes) {
  return content(shapes.solved, shapes.cables, shapes.step);
}

/// Deviations from routes on the cables chosen.
std::string ofRoutes(const Shapes& shapes) {
  std::vector<std::size_t> measures;
  for (const std::size_t index : cable_variation::routeMeasures(shapes.scene)) {
    const std::size_t cable = shapes.scene.measures[index].cables.front();
    if (std::count(shapes.cables.begin(), shapes.cables.end(), cable) > 0) measures.push_back(index);
  }
  const cable_variation::MeasureEvaluator evaluator(shapes.scene, shapes.solved);
  return routeCsv(shapes.scene, measures, evaluator.evaluate(shapes.solved, measures));
}

constexpr std::array<Format, 5> kFormats = {{{"csv", ".csv", ofShapes<cable_variation::shapeCsv>},
                                             {"vtk", ".vtk", ofShapes<cable_variation::shapeVtk>},
                                             {"dxf", ".dxf", ofShapes<cable_variation::shapeDxf>},
                                             {"stl", ".stl", ofShapes<cable_variation::shapeStl>},
                                             {"routes", "_routes.csv", ofRoutes}}};

const Format& formatOf(const std::string& name) {
  for (const Format& format : kFormats) {
    if (name == format.name) return format;
  }
  throw UsageError("--formats: '" + name + "' is none; expected csv, vtk, dxf, stl or routes");
}

class ExportVerb : public Verb {
 public:
  void declare(Options& options) override {
    scene_.declare(options);
    values_.declare("variables", "values", options);
    declareMotion(motion_, time_, options);
    options.texts("cables", "NAME", cables_, "default: all of the scene");
    options.texts("formats", "NAME", formats_,
                  "csv, vtk (ParaView), dxf (a curve for CAD), stl, routes (deviations from planned "
                  "routes); default: csv");
    options.number("step", "LENGTH", "m", step_, "between two sections, at most; default: 2mm");
    options.text("name", "NAME", name_, "write NAME.csv and so on; default: shape");
    files_.declare(options);
  }

  Answer run(cable_variation::RunControl& control) override {
    std::vector<const Format*> formats;
    for (const std::string& name : formats_) formats.push_back(&formatOf(name));
    cable_variation::OutputDirectory::checkName(name_);
    const cable_variation::Design design{scene_.load(control), {}, {}};
    const Scene& scene = design.scene;
    std::vector<std::size_t> cables;
    for (const std::string& name : cables_)
      cables.push_back(cable_variation::indexOf(name, scene.harness.cables, "cable"));
    if (cables.empty()) cables = cable_variation::allIndices(scene.harness.cables.size());
    const DesignValues values = values_.values(scene);
    const ComponentPoses moved = placesAt(design, motion_, time_);
    if (std::count(formats.begin(), formats.end(), &formatOf("routes")) > 0 &&
        cable_variation::routeMeasures(scene).empty())
      throw UsageError("--formats: 'routes': the scene has no measure of the type route_deviation");
    const cable_variation::OutputDirectory output = files_.output();
    output.requireWritable();
    for (const Format* format : formats) keepInputs({scene.source}, output.pathOf(name_, format->ending));
    control.report({"solving"});
    const DesignTrial trial = solveTrial(design, values, moved, nullptr);
    const SolvedScene solved{trial.harness, trial.equilibrium, trial.components};
    std::vector<std::string> contents;
    contents.reserve(formats.size());
    for (const Format* format : formats) contents.push_back(format->content({scene, solved, cables, step_}));
    control.complete();

    Answer answer;
    std::vector<std::string> written;
    for (std::size_t i = 0; i < formats.size(); ++i) {
      const std::string path =
          writeBeside(output, name_, formats[i]->ending, contents[i], answer.status.message);
      if (path.empty()) answer.status.code = cable_variation::StatusCode::io_error;
      if (path.empty()) continue;
      written.push_back(path);
      answer.text += path + "\n";
    }
    answer.warnings = warningsOf(scene);
    answer.warnings.insert(answer.warnings.end(), trial.equilibrium.notes.begin(),
                           trial.equilibrium.notes.end());
    answer.json.set("files", written).set("warnings", trial.equilibrium.notes);
    return answer;
  }

 private:
  SceneOption scene_;
  ValueOptions values_;
  FileOptions files_;
  std::string motion_, name_ = "shape";
  double time_ = 0.0, step_ = 2e-3;
  std::vector<std::string> cables_, formats_{"csv"};
};

}  // namespace

std::unique_ptr<Verb> makeExport() { return std::make_unique<ExportVerb>(); }

}  // namespace cable_variation_command
