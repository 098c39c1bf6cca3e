#include <memory>
#include <numeric>
#include <utility>

#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/scene/enum_names.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/util/count_text.h>
#include <cable_variation/util/number_text.h>
#include <command/loaded_design.h>
#include <command/scene_json.h>
#include <command/scene_options.h>
#include <command/text_table.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::Box;
using cable_variation::Component;
using cable_variation::countText;
using cable_variation::Pose;
using cable_variation::ReportCell;
using cable_variation::ReportTable;
using cable_variation::Scene;

namespace {

std::size_t trianglesOf(const Component& component) {
  std::size_t count = 0;
  for (const cable_variation::Visual& visual : component.visuals)
    count += visual.mesh ? visual.mesh->triangles.size() : 0;
  return count;
}

Box boxOf(const Component& component, const Pose& pose) {
  Box box;
  for (const cable_variation::Visual& visual : component.visuals) {
    if (!visual.mesh) continue;
    const Pose place = pose * visual.pose;
    for (const Eigen::Vector3d& vertex : visual.mesh->vertices) box.add(place * vertex);
  }
  return box;
}

/// Around the centreline's points, with the radius.
Box boxOf(const cable_variation::CableShape& shape) {
  Box box;
  for (const cable_variation::ShapePoint& point : shape.points) box.add(point.pose.position);
  box.low -= shape.radius;
  box.high += shape.radius;
  return box;
}

std::string millimetres(double metres) { return cable_variation::numberText(1e3 * metres, 6); }

void addRow(const std::string& name, const std::string& what, const Box& box, ReportTable& table) {
  std::vector<ReportCell> row{cable_variation::plain(name), cable_variation::plain(what)};
  for (int k = 0; k < 3; ++k) {
    const bool any = box.high[k] >= box.low[k];
    row.push_back(
        cable_variation::plain(any ? millimetres(box.low[k]) + " to " + millimetres(box.high[k]) : "-"));
  }
  table.rows.push_back(row);
}

/// What there is, part by part, with how large it is.
class SceneOverview {
 public:
  explicit SceneOverview(const LoadedDesign& design) : design_(design), scene_(design.scene()) {
    for (const Component& component : scene_.components) addComponent(component);
    for (std::size_t i = 0; i < scene_.harness.cables.size(); ++i) addCable(i);
  }

  std::string text() const {
    std::string text =
        scene_.source + ": " + countText(scene_.components.size(), "component") + " of " +
        countText(triangles_, "triangle") + ", " + countText(scene_.harness.cables.size(), "cable") + ", " +
        countText(scene_.harness.clips.size(), "clip") + ", " +
        countText(scene_.harness.joints.size(), "joint") + ", " +
        countText(scene_.design_variables.size(), "design variable") + ", " +
        countText(scene_.measures.size(), "measure") + ", " + countText(scene_.motions.size(), "motion");
    return wrapped(text) + tableText(table_);
  }

  Json json() const {
    Json clips = Json::array(), measures = Json::array(), motions = Json::array();
    for (std::size_t i = 0; i < scene_.harness.clips.size(); ++i) {
      const cable_variation::Clip& clip = scene_.harness.clips[i];
      Json json = Json::object();
      json.set("name", clip.name).set("type", clip.type).set("cable", scene_.harness.cables[clip.cable].name);
      json.set("arc_length", clip.arc_length).set("attached", clip.attached);
      clips.add(json.set("component", scene_.clip_mounts[i].component).set("world_pose", clip.pose));
    }
    for (const cable_variation::Measure& measure : scene_.measures) measures.add(measureJson(measure));
    for (const cable_variation::Motion& motion : scene_.motions) {
      Json json = Json::object();
      json.set("name", motion.name).set("component", motion.component).set("file", motion.file);
      motions.add(json.set("duration", motion.duration()).set("samples", motion.samples.size()));
    }
    const auto variables = cable_variation::allIndices(scene_.design_variables.size());
    Json json = Json::object();
    json.set("source", scene_.source).set("accuracy", scene_.accuracy);
    json.set("gravity", scene_.harness.gravity).set("components", components_).set("cables", cables_);
    json.set("clips", std::move(clips)).set("design_variables", variablesJson(scene_, variables, {}));
    json.set("measures", std::move(measures)).set("motions", std::move(motions));
    return json.set("warnings", faultsJson(scene_.warnings));
  }

 private:
  void addComponent(const Component& component) {
    const Pose pose = componentPose(scene_, component.name);
    const std::size_t triangles = trianglesOf(component);
    const Box box = boxOf(component, pose);
    triangles_ += triangles;
    addRow(component.name, countText(triangles, "triangle"), box, table_);
    Json json = Json::object();
    json.set("name", component.name).set("parent", component.parent);
    json.set("driven_by", nameOf(component.driven_by)).set("world_pose", pose).set("triangles", triangles);
    if (triangles > 0) json.set("bounding_box", boxJson(box));
    components_.add(std::move(json));
  }

  void addCable(std::size_t index) {
    const cable_variation::Cable& cable = scene_.harness.cables[index];
    const bool solved = design_.equilibrium().converged();
    const Box box = solved ? boxOf(design_.equilibrium().shapes[index]) : Box();
    addRow(cable.name, millimetres(cable.length) + " mm", box, table_);
    Json json = Json::object();
    json.set("name", cable.name).set("length", cable.length).set("mass", massOf(cable));
    if (solved) json.set("bounding_box", boxJson(box));
    cables_.add(std::move(json));
  }

  const LoadedDesign& design_;
  const Scene& scene_;
  std::size_t triangles_ = 0;
  ReportTable table_{"", {"part", "", "x\n[mm]", "y\n[mm]", "z\n[mm]"}, {}};
  Json components_ = Json::array(), cables_ = Json::array();
};

class CheckVerb : public Verb {
 public:
  void declare(Options& options) override { scene_.declare(options); }

  Answer run(cable_variation::RunControl& control) override {
    Scene scene = scene_.load(control);
    Answer answer;
    answer.warnings = warningsOf(scene);
    control.report({"solving"});
    const LoadedDesign design(std::move(scene));
    const SceneOverview overview(design);
    answer.text = overview.text();
    answer.json = overview.json();
    try {
      if (!design.harness().cables.empty())
        requireConverged(design.equilibrium(), "the scene as it is has no equilibrium");
    } catch (const std::exception& error) {
      answer.status = cable_variation::answerStatus(error);
      return answer;
    }
    const std::size_t warnings = answer.warnings.size();
    answer.text += warnings == 0 ? "no faults, nothing implausible\n"
                                 : "no faults, " + countText(warnings, "warning") + "\n";
    return answer;
  }

 private:
  SceneOption scene_;
};

}  // namespace

std::unique_ptr<Verb> makeCheck() { return std::make_unique<CheckVerb>(); }

}  // namespace cable_variation_command
