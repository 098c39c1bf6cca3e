#include <cable_variation/measures/measure_context.h>

#include <cable_variation/scene/measure_place.h>

namespace cable_variation {

MeasureContext::MeasureContext(const Scene& of, const SolvedScene& solved)
    : scene(of), at(solved), cables(viewsOf(solved.harness, solved.equilibrium)) {}

const std::vector<SectionLoads>& MeasureContext::loads(std::size_t cable) const {
  loads_.resize(cables.size());
  std::vector<SectionLoads>& loads = loads_[cable];
  if (loads.empty()) {
    const CableView& view = cables[cable];
    loads.reserve(view.pieces().size());
    for (std::size_t i = 0; i < view.pieces().size(); ++i) loads.emplace_back(view, i, at.harness.gravity);
  }
  return loads;
}

CableRates MeasureRates::cable(std::size_t index) const {
  static const CableRate unchanged;
  for (const CableRate& rate : design.harness.cables) {
    if (rate.cable == index) return {equilibrium.shapes[index], rate};
  }
  return {equilibrium.shapes[index], unchanged};
}

NamedPlace::NamedPlace(const MeasureContext& context, std::size_t cable, double arc_length) {
  const CableView& view = context.cables[cable];
  const bool end = isEnd(arc_length, context.scene.harness.cables[cable].length);
  place = end ? Place{view.pieces().size() - 1, 1.0} : view.at(arc_length);
  at_end = view.isEnd(place);
}

double NamedPlace::shareRate(const CableView& view, const CableRates& rates) const {
  return at_end ? 0.0 : view.shareRate(place, rates, 0.0);
}

MeasureValue measureAt(const MeasureContext& context, std::size_t cable, const Place& place, double value) {
  const CableView& view = context.cables[cable];
  MeasureValue result;
  result.value = value;
  result.has_place = true;
  result.cable = cable;
  result.arc_length = view.arcLength(place);
  result.point = view.line().position(place);
  result.trace.place = place;
  return result;
}

void markAsShared(MeasureValue& value, const std::string& note) {
  value.unique = false;
  value.note += (value.note.empty() ? "" : "; ") + note;
}

}  // namespace cable_variation
