#include <memory>
#include <utility>

#include <cable_variation/analysis/envelope_calculation.h>
#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/report/envelope_section.h>
#include <cable_variation/util/number_text.h>
#include <command/envelope_json.h>
#include <command/loaded_design.h>
#include <command/scene_options.h>
#include <command/text_table.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::EnvelopeCalculation;
using cable_variation::EnvelopeFiles;
using cable_variation::EnvelopeFindings;
using cable_variation::EnvelopeTask;
using cable_variation::numberText;
using cable_variation::Scene;

namespace {

std::string textOf(const Scene& scene, const EnvelopeTask& task, const EnvelopeCalculation& found) {
  const EnvelopeFindings findings{
      task.options, found.envelope, found.clearances, found.surfaces.whole.mesh, found.surfaces.whole.excess,
      found.volume};
  std::string text = tableText(envelopeTable(findings)) + wrapped(containmentText(found.envelope)) + "\n";
  if (!findings.clearances.empty()) text += tableText(clearanceTable(scene, findings)) + "\n";
  const double effort = found.envelope.solve_time + found.clearance_time + found.surface_time;
  return text + numberText(effort, 3) + " s, checked in " + numberText(found.envelope.verify_time, 3) +
         " s\n";
}

class EnvelopeVerb : public Verb {
 public:
  void declare(Options& options) override {
    scene_.declare(options);
    options.texts("cables", "NAME", request_.cables, "default: all of the scene");
    options.texts("variables", "NAME", request_.variables, "that vary within their tolerances; default: all");
    options.flag("motion_only", request_.motion_only, "nothing varies: the nominal cables over --motions");
    options.texts("motions", "NAME", request_.motions, "played together; default: at rest");
    options.number("from_time", "TIME", "s", request_.from_time, "of the motions");
    options.number("to_time", "TIME", "s", request_.to_time, "likewise; default: their end");
    values_.declare("nominal_variables", "nominal_values", options);
    options.number("probability", "SHARE", "1", request_.probability,
                   "of production that is to be held, as 0.9973; default: the worst case");
    options.number("margin", "LENGTH", "m", request_.margin,
                   "that shapes may stick out before inflation; default: 0.1mm");
    options.flag("non_conservative", request_.non_conservative, "leave out the inflation");
    options.count("verification_shapes", "COUNT", request_.verification_shapes,
                  "independent ones for containment; default: 2000");
    options.count("tightness_shapes", "COUNT", request_.tightness_shapes, "to compare volumes; default: not");
    options.number("tightness_voxel", "LENGTH", "m", request_.tightness_voxel,
                   "default: a sixth of the thinnest cable's radius");
    options.count("seed", "NUMBER", request_.seed, "of the random shapes; default: 1");
    options.number("mesh_excess", "LENGTH", "m", request_.mesh_excess,
                   "that the mesh may be outside; default: what 80,000 triangles allow");
    options.number("skip_near_clips", "LENGTH", "m", request_.skip_near_clips,
                   "stretches not held against what they are clipped on; default: as the scene has it");
    options.text("name", "NAME", request_.name, "write NAME.stl, NAME.urdf, NAME.obj and NAME.html");
    files_.declare(options);
    limits_.declare(options);
  }

  Answer run(cable_variation::RunControl& control) override {
    const LoadedDesign design(scene_.load(control), files_.author);
    const Scene& loaded = design.scene();
    values_.resolve(loaded, request_.nominal_variables, request_.nominal_values);
    if (request_.variables.empty() && !request_.motion_only) request_.variables = {"*"};
    const EnvelopeTask task =
        toEnvelopeTask(request_, design.design(), {}, limits_.threads, limits_.memory_limit);
    const cable_variation::OutputDirectory output = files_.output();
    if (!task.name.empty()) output.requireWritable();
    const cable_variation::DesignSnapshot snapshot = snapshotFor(task.options, design.snapshot());
    const EnvelopeCalculation found = calculateEnvelope(task, snapshot, false, control);
    const Scene& scene = snapshot.design.scene;

    Answer answer;
    answer.json = envelopeJson(scene, task, found);
    answer.text = textOf(scene, task, found);
    std::vector<std::string> warnings = found.warnings;
    const EnvelopeFiles files = writeEnvelope(task, snapshot, found, output, warnings, control);
    if (!files.error.empty()) answer.status = {cable_variation::StatusCode::io_error, files.error};
    answer.json.set("warnings", warnings).set("mesh_file", files.mesh).set("urdf_file", files.urdf);
    answer.json.set("region_file", files.region).set("report_file", files.report);
    for (const std::string& file : {files.mesh, files.urdf, files.region, files.report})
      answer.text += file.empty() ? "" : file + "\n";
    answer.warnings = warningsOf(scene);
    answer.warnings.insert(answer.warnings.end(), warnings.begin(), warnings.end());
    return answer;
  }

 private:
  SceneOption scene_;
  ValueOptions values_;
  FileOptions files_;
  LimitOptions limits_;
  cable_variation::EnvelopeRequest request_;
};

}  // namespace

std::unique_ptr<Verb> makeEnvelope() { return std::make_unique<EnvelopeVerb>(); }

}  // namespace cable_variation_command
