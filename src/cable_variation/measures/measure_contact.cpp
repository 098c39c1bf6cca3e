#include <cable_variation/measures/measure_contact.h>

#include <algorithm>
#include <functional>
#include <vector>

#include <cable_variation/scene/moving_components.h>

namespace cable_variation {
namespace {

double figureOf(const Measure& measure, const ContactInterval& interval) {
  return measure.type == Measure::Type::contact_force ? interval.total : interval.end - interval.start;
}

// Where it is pressed hardest.
void place(const ContactInterval& interval, MeasureValue& value) {
  const auto hardest =
      std::max_element(interval.places.begin(), interval.places.end(),
                       [](const ContactForce& a, const ContactForce& b) { return a.force < b.force; });
  if (hardest == interval.places.end()) return;
  value.has_place = true;
  value.cable = interval.cable;
  value.arc_length = hardest->arc_length;
  value.point = hardest->on_part;
}

// Whether a contact, by its index, is one with the measure's component.
std::function<bool(std::size_t)> countsFor(const MeasureContext& context, const Measure& measure) {
  return [&context, bodies = bodiesOf(context.scene, *measure.component)](std::size_t contact) {
    return std::find(bodies.begin(), bodies.end(), context.scene.contact_components.at(contact)) !=
           bodies.end();
  };
}

}  // namespace

double contactForceRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value,
                        const MeasureRates& rates) {
  if (!value.has_place) return 0.0;
  const auto counts = countsFor(context, measure);
  double rate = 0.0;
  for (const ContactForceRate& at : rates.equilibrium.contacts) {
    if (at.cable == value.cable && counts(at.contact)) rate += at.force;
  }
  return rate;
}

MeasureValue contactValue(const MeasureContext& context, const Measure& measure) {
  const auto counts = countsFor(context, measure);
  MeasureValue worst;
  for (const std::size_t cable : measure.cables) {
    MeasureValue value;
    double largest = -1.0;
    for (const ContactInterval& interval : context.at.equilibrium.contacts) {
      if (interval.cable != cable || !counts(interval.contact)) continue;
      const double figure = figureOf(measure, interval);
      value.value += figure;
      if (figure <= largest) continue;
      largest = figure;
      place(interval, value);
    }
    if (value.value > worst.value || (value.has_place && !worst.has_place)) worst = value;
  }
  return worst;
}

}  // namespace cable_variation
