#include <array>
#include <memory>
#include <utility>

#include <cable_variation/analysis/answer_files.h>
#include <cable_variation/analysis/design_trial.h>
#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/analysis/scene_loading.h>
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

/// A kind of file; `extension` is its name, too.
struct Format {
  const char* extension;
  std::string (*content)(const SolvedScene& solved, const std::vector<std::size_t>& cables, double step);
};

constexpr std::array<Format, 4> kFormats = {{{"csv", cable_variation::shapeCsv},
                                             {"vtk", cable_variation::shapeVtk},
                                             {"dxf", cable_variation::shapeDxf},
                                             {"stl", cable_variation::shapeStl}}};

const Format& formatOf(const std::string& name) {
  for (const Format& format : kFormats) {
    if (name == format.extension) return format;
  }
  throw UsageError("--formats: '" + name + "' is none; expected csv, vtk, dxf or stl");
}

class ExportVerb : public Verb {
 public:
  void declare(Options& options) override {
    scene_.declare(options);
    values_.declare("variables", "values", options);
    declareMotion(motion_, time_, options);
    options.texts("cables", "NAME", cables_, "default: all of the scene");
    options.texts("formats", "NAME", formats_,
                  "csv, vtk (ParaView), dxf (a curve for CAD), stl; default: csv");
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
    const cable_variation::OutputDirectory output = files_.output();
    output.requireWritable();
    for (const Format* format : formats)
      keepInputs({scene.source}, output.pathOf(name_, "." + std::string(format->extension)));
    control.report({"solving"});
    const DesignTrial trial = solveTrial(design, values, moved, nullptr);
    const SolvedScene solved{trial.harness, trial.equilibrium, trial.components};
    std::vector<std::string> contents;
    contents.reserve(formats.size());
    for (const Format* format : formats) contents.push_back(format->content(solved, cables, step_));
    control.complete();

    Answer answer;
    std::vector<std::string> written;
    for (std::size_t i = 0; i < formats.size(); ++i) {
      const std::string path = writeBeside(output, name_, "." + std::string(formats[i]->extension),
                                           contents[i], answer.status.message);
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
