#include <ros_interface/context/measured_shape.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include <cable_variation/scene/measure_traits.h>
#include <cable_variation/util/error.h>
#include <ros_interface/context/solver_context.h>

namespace cable_variation_ros {

using cable_variation::Measure;
using cable_variation::MeasureValue;
using cable_variation::Scene;
using cable_variation::SolvedScene;

namespace {

bool needsNominal(const Measure& measure) { return traitsOf(measure.type).from_nominal; }

MeasureValue withoutNominal() {
  MeasureValue value;
  value.value = std::numeric_limits<double>::quiet_NaN();
  value.note = "the scene as it was loaded has no equilibrium to compare with";
  return value;
}

}  // namespace

void MeasuredShape::prepare() {
  if (evaluator_ && design_number_ == context_.designNumber()) return;
  const Scene& scene = context_.design().scene;
  evaluator_.emplace(context_.evaluatorInForce());
  has_nominal_ = false;
  if (std::any_of(scene.measures.begin(), scene.measures.end(), needsNominal)) {
    try {
      const SolverContext::Trial& nominal = context_.asLoaded();
      evaluator_.emplace(evaluator_->with(scene, {nominal.harness, nominal.equilibrium, nominal.components}));
      has_nominal_ = true;
    } catch (const cable_variation::Error&) {
      // values() says so of each similarity
    }
  }
  design_number_ = context_.designNumber();
  all_.resize(scene.measures.size());
  std::iota(all_.begin(), all_.end(), std::size_t{0});
  values_.clear();
}

const std::vector<MeasureValue>& MeasuredShape::values() {
  if (current_) return values_;
  current_ = true;
  if (!context_.equilibrium().converged()) {
    values_.clear();
    return values_;
  }
  prepare();
  const cable_variation::ComponentPoses components = context_.components();
  const std::vector<MeasureValue> before = std::move(values_);
  values_ = evaluator_->evaluate(SolvedScene{context_.harness(), context_.equilibrium(), components}, all_,
                                 before.empty() ? nullptr : &before);
  for (std::size_t i = 0; i < all_.size() && !has_nominal_; ++i) {
    if (needsNominal(context_.design().scene.measures[i])) values_[i] = withoutNominal();
  }
  return values_;
}

}  // namespace cable_variation_ros
