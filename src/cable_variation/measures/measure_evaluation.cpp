#include <cable_variation/measures/measure_evaluation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include <cable_variation/geometry/tube_distance/part_vicinity.h>
#include <cable_variation/measures/measure_functions.h>
#include <cable_variation/scene/measure_traits.h>

namespace cable_variation {
namespace {

bool measuresToPart(const Measure& measure) { return traitsOf(measure.type).clearance && measure.component; }

}  // namespace

struct MeasureEvaluator::Impl {
  const Scene& scene;
  std::vector<Centreline> nominal;                              // per cable
  ComponentParts parts;                                         // that measures need
  std::map<std::size_t, std::vector<MeasuredBody>> bodies;      // of measures to a component
  std::map<std::size_t, std::vector<PartVicinity>> vicinities;  // of measures, per body and cable of theirs

  Impl(const Scene& of, const SolvedScene& solved, const ComponentParts& known) : scene(of) {
    for (std::size_t i = 0; i < solved.equilibrium.shapes.size(); ++i)
      nominal.push_back(centrelineOf(solved.harness.cables[i], solved.equilibrium.shapes[i]));
    for (std::size_t i = 0; i < scene.measures.size(); ++i) {
      const Measure& measure = scene.measures[i];
      if (!measuresToPart(measure)) continue;
      try {
        for (const std::size_t component : measuredComponents(scene, *measure.component)) {
          parts.prepare(scene, component, known);
          bodies[i].push_back({component, parts.find(component)});
        }
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("measure '" + measure.name + "': " + error.what());
      }
    }
  }

  const Measure& measure(std::size_t index) const {
    if (index >= scene.measures.size()) {
      throw std::invalid_argument("measure " + std::to_string(index) + " of " +
                                  std::to_string(scene.measures.size()));
    }
    return scene.measures[index];
  }

  MeasureValue value(const MeasureContext& context, std::size_t index, const MeasureValue* near) const {
    const Measure& measure = this->measure(index);
    return functionsOf(measure.type)
        .value(context, measure, {nominal, of(bodies, index), near, of(vicinities, index)});
  }

  // What there is of a measure.
  template <class Thing>
  static const std::vector<Thing>& of(const std::map<std::size_t, std::vector<Thing>>& all,
                                      std::size_t index) {
    static const std::vector<Thing> none;
    const auto found = all.find(index);
    return found == all.end() ? none : found->second;
  }
};

namespace {

// Whether a measure is known of an equilibrium in which cables touch parts. Between a shape's points, section
// forces are those that balance what is spread along the cable; what parts press with is not yet among it.
bool isKnown(const Equilibrium& equilibrium, const Measure& measure) {
  switch (measure.type) {
    case Measure::Type::eigenvalue:
      return !std::isnan(equilibrium.smallest_eigenvalue);
    case Measure::Type::strain:
    case Measure::Type::stress:
    case Measure::Type::section_force:
    case Measure::Type::section_moment:
    case Measure::Type::twist:
      return std::none_of(equilibrium.contacts.begin(), equilibrium.contacts.end(),
                          [&](const ContactInterval& interval) {
                            return std::find(measure.cables.begin(), measure.cables.end(), interval.cable) !=
                                   measure.cables.end();
                          });
    default:
      return true;
  }
}

MeasureValue unknownInContact(const Measure& measure) {
  MeasureValue none;
  none.value = std::numeric_limits<double>::quiet_NaN();
  none.note = std::string("not yet known where a cable touches a part: ") + toString(measure.type);
  return none;
}

}  // namespace

MeasureEvaluator::MeasureEvaluator(const Scene& scene, const SolvedScene& nominal)
    : impl_(std::make_unique<Impl>(scene, nominal, ComponentParts())) {}
MeasureEvaluator::~MeasureEvaluator() = default;
MeasureEvaluator::MeasureEvaluator(MeasureEvaluator&&) noexcept = default;
MeasureEvaluator& MeasureEvaluator::operator=(MeasureEvaluator&&) noexcept = default;

MeasureEvaluator::MeasureEvaluator(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

MeasureEvaluator MeasureEvaluator::with(const Scene& scene, const SolvedScene& nominal) const {
  return MeasureEvaluator(std::make_unique<Impl>(scene, nominal, impl_->parts));
}

void MeasureEvaluator::expectNear(const SolvedScene& nominal, const std::vector<std::size_t>& measures,
                                  const std::vector<MeasureValue>& values, double departure) {
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const Measure& measure = impl_->measure(measures[i]);
    if (!measuresToPart(measure) || !std::isfinite(values[i].value)) continue;
    // a shape that has gone this far may be that much closer, and then see what is as far again
    const double reach = std::max(values[i].value, 0.0) + 2.0 * departure;
    std::vector<PartVicinity>& vicinities = impl_->vicinities[measures[i]];
    vicinities.clear();
    for (const MeasuredBody& body : impl_->bodies.at(measures[i])) {
      const Pose& pose = nominal.components.at(impl_->scene.components[body.component].name);
      for (const std::size_t cable : measure.cables)
        vicinities.emplace_back(impl_->nominal[cable], *body.part, pose, reach);
    }
  }
}

const ComponentParts& MeasureEvaluator::parts() const { return impl_->parts; }

std::vector<MeasureValue> MeasureEvaluator::evaluate(const SolvedScene& at,
                                                     const std::vector<std::size_t>& measures,
                                                     const std::vector<MeasureValue>* near) const {
  const MeasureContext context(impl_->scene, at);
  std::vector<MeasureValue> values;
  values.reserve(measures.size());
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const MeasureValue* known = near != nullptr && i < near->size() ? &(*near)[i] : nullptr;
    const Measure& measure = impl_->measure(measures[i]);
    values.push_back(isKnown(at.equilibrium, measure) ? impl_->value(context, measures[i], known)
                                                      : unknownInContact(measure));
  }
  return values;
}

Eigen::MatrixXd MeasureEvaluator::jacobian(const SolvedScene& at, const std::vector<std::size_t>& measures,
                                           const std::vector<MeasureValue>& values,
                                           const std::vector<DesignRate>& design,
                                           const std::vector<EquilibriumRate>& rates) const {
  if (values.size() != measures.size() || rates.size() != design.size()) {
    throw std::invalid_argument("derivatives of measures: " + std::to_string(measures.size()) +
                                " measures with " + std::to_string(values.size()) + " values, " +
                                std::to_string(design.size()) + " variables with " +
                                std::to_string(rates.size()) + " equilibrium rates");
  }
  const MeasureContext context(impl_->scene, at);
  Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(measures.size()),
                           static_cast<Eigen::Index>(design.size()));
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const Measure& measure = impl_->measure(measures[i]);
    const RateOfMeasure rate = functionsOf(measure.type).rate(context, measure, values[i]);
    for (std::size_t j = 0; j < design.size(); ++j) {
      jacobian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rate({design[j], rates[j]});
    }
  }
  return jacobian;
}

}  // namespace cable_variation
