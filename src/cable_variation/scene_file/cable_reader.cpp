#include <cmath>
#include <stdexcept>

#include <cable_variation/scene_file/read_context.h>
#include <cable_variation/scene_file/section_reader.h>

namespace cable_variation {
namespace {

// `at` of the entries of a list along the cable; they must not decrease.
class ArcLengths {
 public:
  explicit ArcLengths(double cable_length) : cable_length_(cable_length) {}

  double read(const YamlCursor& item) {
    const auto at = item.require("at");
    if (!at) return last_;
    const double arc_length = readArcLength(*at, cable_length_);
    if (arc_length < last_) {
      at->fail(shortNumber(arc_length) + " m comes after " + shortNumber(last_) +
               " m; expected increasing values");
    }
    if (!std::isnan(arc_length)) last_ = arc_length;
    return arc_length;
  }

 private:
  double cable_length_;
  double last_ = 0.0;
};

void readSections(const YamlCursor& list, Cable& cable, std::vector<bool>& geometric, ReadContext& context) {
  ArcLengths arc_lengths(cable.length);
  if (!list.isAtMost(context.limits.sections, "sections")) return;
  const std::vector<YamlCursor> items = list.items();
  if (list.isList() && items.empty()) list.fail("the list is empty; expected a section at least");
  for (const YamlCursor& item : items) {
    if (!item.checkKeys({"at", "section", "stiffness"})) continue;
    const double at = arc_lengths.read(item);
    if (const auto section = readSection(item, context.materials)) cable.sections.push_back({at, *section});
    geometric.push_back(item.has("section"));
  }
}

void readRestShape(const YamlCursor& shape, Cable& cable, const InputLimits& limits) {
  if (!shape.checkKeys({"points", "curvature"})) return;
  const auto points = shape.find("points");
  const auto curvature = shape.find("curvature");
  if (!points == !curvature) {
    shape.fail("expected either 'points' or 'curvature'");
    return;
  }
  const std::size_t before = shape.faults().count();
  if (!(points ? *points : *curvature).isAtMost(limits.rest_points, "rest_points")) return;
  if (curvature) {
    ArcLengths arc_lengths(cable.length);
    for (const YamlCursor& item : curvature->items()) {
      if (!item.checkKeys({"at", "value"})) continue;
      const double at = arc_lengths.read(item);
      cable.rest_curvature.push_back({at, item.vector("value", quantity::curvature)});
    }
    return;
  }
  std::vector<Eigen::Vector3d> through;
  for (const YamlCursor& item : points->items()) through.push_back(item.vector(quantity::length));
  if (shape.faults().count() > before || !(cable.length > 0.0)) return;
  try {
    cable.rest_curvature = restCurvatureThrough(through, cable.length);
  } catch (const std::invalid_argument& error) {
    points->fail(error.what());
  }
}

double readTwist(const YamlCursor& cursor, std::size_t most_turns) {
  const double twist = cursor.number(quantity::angle);
  if (std::abs(twist) > 2.0 * M_PI * static_cast<double>(most_turns)) {
    cursor.fail("found " + shortNumber(twist / (2.0 * M_PI)) + " turns; " + atMost(most_turns, "turns"));
  }
  return twist;
}

void readCable(const YamlCursor& item, Cable& cable, ReadContext& context) {
  if (!item.checkKeys({"name", "length", "section", "stiffness", "sections", "rest_shape", "via", "twist"}))
    return;
  const std::size_t before = context.faults.count();
  cable.length = item.number("length", quantity::length, Range::positive());

  std::vector<bool> geometric;
  if (const auto sections = item.find("sections")) {
    for (const char* key : {"section", "stiffness"}) {
      if (item.has(key)) item.find(key)->fail("'sections' is there too; expected one of them");
    }
    readSections(*sections, cable, geometric, context);
  } else {
    if (const auto section = readSection(item, context.materials)) cable.sections.push_back({0.0, *section});
    geometric.push_back(item.has("section"));
  }
  bool uniform = true;
  for (const bool one : geometric) uniform = uniform && one == geometric.front();
  if (uniform && !geometric.empty())
    context.geometric_sections[context.scene.harness.cables.size()] = geometric.front();

  if (const auto shape = item.find("rest_shape")) readRestShape(*shape, cable, context.limits);
  const auto via = item.find("via");
  if (via && via->isAtMost(context.limits.via_points, "via_points")) {
    for (const YamlCursor& point : via->items()) cable.via.push_back(point.vector(quantity::length));
  }
  if (const auto twist = item.find("twist")) cable.twist = readTwist(*twist, context.limits.turns);
  if (context.faults.count() > before || cable.sections.size() < geometric.size()) return;
  try {
    validate(cable);
  } catch (const std::invalid_argument& error) {
    context.faults.add(item.line(), error.what());
  }
}

}  // namespace

void readMaterials(const YamlCursor& map, ReadContext& context) {
  if (!map.isMap()) map.fail("expected a map from names to materials");
  for (const auto& [name, value] : map.entries()) {
    const Material material = readMaterial(value.labelled("material '" + name + "'"));
    if (!context.materials.emplace(name, material).second)
      value.fail("there is a material '" + name + "' already");
  }
}

void readCables(const YamlCursor& list, ReadContext& context) {
  readEach(list, context.cables, context.scene.harness.cables,
           [&](const YamlCursor& item, Cable& cable) { readCable(item, cable, context); });
}

}  // namespace cable_variation
