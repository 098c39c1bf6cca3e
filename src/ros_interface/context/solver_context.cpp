#include <ros_interface/context/solver_context.h>

#include <utility>

#include <cable_variation/analysis/design_snapshot.h>
#include <cable_variation/analysis/design_stability.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/report/design_changes.h>
#include <cable_variation/scene/design_rate.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/sha256.h>

namespace cable_variation_ros {

using cable_variation::ComponentPoses;
using cable_variation::Design;
using cable_variation::DesignValues;
using cable_variation::Equilibrium;
using cable_variation::EquilibriumSolver;
using cable_variation::Harness;
using cable_variation::InputLimits;
using cable_variation::MeasureEvaluator;
using cable_variation::MeasureValue;
using cable_variation::Scene;
using cable_variation::SolvedScene;
using cable_variation::StabilityAnalysis;
using cable_variation::StabilityOptions;

namespace {

std::string textOf(const Scene& scene, const InputLimits& limits) {
  try {
    return cable_variation::readSceneFile(scene.source, limits);
  } catch (const std::invalid_argument&) {  // made in memory, or taken away meanwhile
    return "";
  }
}

void requireShape(const Equilibrium& equilibrium, const Harness& harness) {
  if (!harness.cables.empty()) requireConverged(equilibrium);
}

}  // namespace

SolverContext::SolverContext(Scene scene, const InputLimits& limits)
    : limits_(limits),
      loaded_(std::move(scene)),
      loaded_text_(textOf(loaded_, limits)),
      design_{loaded_, {}, {}},
      harness_(harnessAt(design_, {}, moved_)),
      solver_(newSolver(loaded_)),
      equilibrium_(shapeFromNothing(solver_, harness_)) {
  if (equilibrium_.converged()) as_loaded_ = Trial{harness_, equilibrium_, components()};
}

void SolverContext::notify() {
  evaluator_in_force_ = false;
  if (changed_) changed_();
}

void SolverContext::take(EquilibriumSolver solver, Design design, Harness harness, Equilibrium equilibrium,
                         bool edited, std::optional<cable_variation::AttachedClips> attachment) {
  requireShape(equilibrium, harness);
  attached_before_.clear();
  for (const cable_variation::Clip& clip : design_.scene.harness.clips)
    attached_before_.push_back(clip.attached);
  solver_ = std::move(solver);
  design_ = std::move(design);
  moved_ = placesOf(design_, on_tf_);
  harness_ = std::move(harness);
  equilibrium_ = std::move(equilibrium);
  jump_ = attachment ? attachment->followed.jump : std::nullopt;
  attachment_ = std::move(attachment);
  ++design_number_;
  if (on_tf_.empty()) stamp_ = ros::Time::now();
  edited_ = edited;
  notify();
}

void SolverContext::load(Scene scene) {
  std::string text = textOf(scene, limits_);
  Design design{std::move(scene), {}, {}};
  Harness harness = harnessAt(design, {});
  EquilibriumSolver solver = newSolver(design.scene);
  Equilibrium equilibrium = shapeFromNothing(solver, harness);
  requireShape(equilibrium, harness);
  replaceScene(design.scene, std::move(text));
  if (equilibrium.converged())
    as_loaded_ = Trial{harness, equilibrium, componentPosesAt(design.scene, {}, {})};
  ++loads_;
  take(std::move(solver), std::move(design), std::move(harness), std::move(equilibrium), false);
}

void SolverContext::restore(Scene loaded, cable_variation::SavedDesign saved) {
  std::string text = textOf(loaded, limits_);
  Harness harness = harnessAt(saved.design, {}, placesOf(saved.design, {}));
  EquilibriumSolver solver = newSolver(loaded);
  Equilibrium equilibrium =
      harness.cables.empty() ? shapeFromNothing(solver, harness) : solveSaved(solver, harness, saved.shape);
  requireShape(equilibrium, harness);
  if (loaded.source != loaded_.source) ++loads_;
  replaceScene(std::move(loaded), std::move(text));
  take(std::move(solver), std::move(saved.design), std::move(harness), std::move(equilibrium), true);
}

void SolverContext::replaceScene(Scene loaded, std::string text) {
  loaded_ = std::move(loaded);
  loaded_text_ = std::move(text);
  on_tf_.clear();
  moved_.clear();
  evaluator_.reset();
  as_loaded_.reset();
}

void SolverContext::reset() {
  Design design{loaded_, {}, {}};
  Harness harness = harnessAt(design, {}, on_tf_);
  EquilibriumSolver solver = newSolver(loaded_);
  Equilibrium equilibrium = shapeFromNothing(solver, harness);
  take(std::move(solver), std::move(design), std::move(harness), std::move(equilibrium), false);
}

void SolverContext::adopt(Design design) {
  Harness harness = harnessAt(design, {}, placesOf(design, on_tf_));
  EquilibriumSolver solver = solver_;
  Equilibrium equilibrium = harness.cables.empty() ? Equilibrium() : solver.update(harness);
  if (!equilibrium.converged()) equilibrium = shapeFromNothing(solver, harness);
  take(std::move(solver), std::move(design), std::move(harness), std::move(equilibrium), true);
}

void SolverContext::attach(Design design) {
  requireConverged(equilibrium_);
  Harness harness = harnessAt(design, {}, moved_);
  EquilibriumSolver solver = solver_;
  cable_variation::AttachedClips attached = followAttachment(solver, harness_, equilibrium_, harness);
  Equilibrium equilibrium = attached.followed.equilibrium;
  take(std::move(solver), std::move(design), std::move(harness), std::move(equilibrium), true,
       std::move(attached));
}

void SolverContext::move(const ComponentPoses& on_tf, const ros::Time& stamp) {
  ComponentPoses moved = placesOf(design_, on_tf);
  Harness harness = harnessAt(design_, {}, moved);
  EquilibriumSolver solver = solver_;  // without an equilibrium there, the last one is still where to go on
  cable_variation::FollowedClips followed;
  if (equilibrium_.converged()) {
    followed = followClips(solver, harness_, equilibrium_, harness);
    if (!followed.equilibrium.converged()) last_shape_ = std::move(equilibrium_);
  } else {
    followed.equilibrium =
        harness.cables.empty() ? shapeFromNothing(solver, harness) : solver.update(harness);
  }
  if (followed.equilibrium.converged()) solver_ = std::move(solver);
  on_tf_ = on_tf;
  moved_ = std::move(moved);
  stamp_ = stamp;
  harness_ = std::move(harness);
  equilibrium_ = std::move(followed.equilibrium);
  jump_ = followed.jump;
  attachment_.reset();
  notify();
}

void SolverContext::confirm(const ros::Time& stamp) {
  if (stamp == stamp_) return;
  stamp_ = stamp;
  if (confirmed_) confirmed_();
}

cable_variation::DesignOrigin SolverContext::origin() const {
  return {loaded_text_.empty() ? "" : cable_variation::sha256(loaded_text_),
          designChanges(loaded_, design_.scene, design_.shifts), author_};
}

SolverContext::Snapshot SolverContext::snapshot() const {
  return {design_, moved_, solver_, parts(), design_number_, origin(), on_tf_};
}

cable_variation::ComponentParts SolverContext::parts() const {
  return evaluator_ ? evaluator_->parts() : cable_variation::ComponentParts();
}

ComponentPoses SolverContext::components() const {
  return componentPosesAt(design_.scene, design_.shifted, moved_);
}

MeasureEvaluator SolverContext::evaluator(const Snapshot& snapshot) const {
  const ComponentPoses here = components();
  const SolvedScene any{harness_, equilibrium_, here};
  return preparedEvaluator(any).with(snapshot.design.scene, any);
}

MeasureEvaluator SolverContext::evaluatorInForce() const {
  const ComponentPoses here = components();
  const SolvedScene in_force{harness_, equilibrium_, here};
  return preparedEvaluator(in_force).with(design_.scene, in_force);
}

SolverContext::Trial SolverContext::solve(const DesignValues& values, const ComponentPoses& moved,
                                          bool follow) const {
  return solveTrial(design_, values, moved, follow ? &solver_ : nullptr);
}

const MeasureEvaluator& SolverContext::preparedEvaluator(const SolvedScene& any) const {
  if (!evaluator_) evaluator_.emplace(design_.scene, any);
  return *evaluator_;
}

std::vector<MeasureValue> SolverContext::measure(const SolvedScene& at,
                                                 const std::vector<std::size_t>& measures) const {
  if (equilibrium_.converged()) {
    if (!evaluator_in_force_) {
      evaluator_ = evaluatorInForce();
      evaluator_in_force_ = true;
    }
    return measureTrial(design_.scene, *evaluator_, true, at, measures);
  }
  return measureTrial(design_.scene, preparedEvaluator(at), false, at, measures);
}

std::vector<MeasureValue> SolverContext::measure(const Trial& trial,
                                                 const std::vector<std::size_t>& measures) const {
  return measure(SolvedScene{trial.harness, trial.equilibrium, trial.components}, measures);
}

const SolverContext::Trial& SolverContext::asLoaded() const {
  if (!as_loaded_) {
    const Design design{loaded_, {}, {}};
    EquilibriumSolver solver = newSolver(loaded_);
    Trial trial{harnessAt(design, {}), {}, componentPosesAt(loaded_, {}, {})};
    trial.equilibrium = shapeFromNothing(solver, trial.harness);
    as_loaded_ = std::move(trial);
  }
  requireConverged(as_loaded_->equilibrium);
  return *as_loaded_;
}

StabilityAnalysis SolverContext::analyse(StabilityOptions& options) const {
  const auto prepared = [this](const SolvedScene& any) -> const MeasureEvaluator& {
    return preparedEvaluator(any);
  };
  return analyseDesign(design_, moved_, equilibrium_, solver_, prepared, options);
}

cable_variation::EquilibriumRate SolverContext::shapeRate(std::size_t variable) const {
  EquilibriumSolver solver = solver_;
  const auto design = designRates(design_.scene, design_.shifted, moved_, {variable});
  return solver.differentiate({design.front().harness}).front();
}

}  // namespace cable_variation_ros
