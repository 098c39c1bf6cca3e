#include <cable_variation/scene_file/distribution_reader.h>
#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {
namespace {

using Shape = ToleranceRegion::Shape;

const char* const kAxisNames[] = {"x", "y", "z"};

// The key that names the axis which a shape leaves out.
const char* axisKeyOf(Shape shape) {
  switch (shape) {
    case Shape::ball:
      return nullptr;
    case Shape::disc:
      return "normal";
    case Shape::cone:
      break;
  }
  return "axis";
}

void readSpread(const YamlCursor& distribution, ToleranceRegion& region) {
  if (!distribution.isMap()) {
    distribution.fail("expected a map such as {type: normal, sigma: 3}");
    return;
  }
  const std::size_t before = distribution.faults().count();
  region.uniform = distribution.choice("type", {"normal", "uniform"}) == 1;
  if (distribution.faults().count() > before) return;
  if (region.uniform) {
    distribution.checkKeys({"type"});
    return;
  }
  distribution.checkKeys({"type", "sigma"});
  region.sigma = distribution.number("sigma", quantity::number, kSigmaRange, region.sigma);
}

DesignTarget targetOf(bool of_clip, Shape shape, std::size_t moved, Axis axis) {
  if (shape == Shape::cone) {
    return of_clip ? DesignTarget(ClipRotation{moved, axis}) : DesignTarget(ComponentRotation{moved, axis});
  }
  return of_clip ? DesignTarget(ClipTranslation{moved, axis})
                 : DesignTarget(ComponentTranslation{moved, axis});
}

}  // namespace

void readToleranceRegion(const YamlCursor& entry, ReadContext& context) {
  const YamlCursor item = context.tolerance_regions.add(entry);
  ToleranceRegion region;
  region.name = context.tolerance_regions.names().back();
  region.uniform = false;
  const std::size_t before = context.faults.count();
  item.checkKeys({"name", "clip", "component", "region", "normal", "axis", "tolerance", "distribution"});
  const bool of_clip = item.has("clip");
  if (of_clip == item.has("component")) item.fail("expected one of clip and component, for a region");
  const std::size_t moved = of_clip                 ? context.clips.find(item, "clip")
                            : item.has("component") ? context.components.find(item, "component")
                                                    : NameTable::npos;

  const auto shapeName = item.find("region");
  const std::size_t before_shape = context.faults.count();
  region.shape = static_cast<Shape>(shapeName->choice({"ball", "disc", "cone"}));
  if (context.faults.count() > before_shape) return;
  const char* const axis_key = axisKeyOf(region.shape);
  for (const auto& [key, shape] : {std::pair("normal", "disc"), std::pair("axis", "cone")}) {
    const bool wanted = axis_key && std::string(axis_key) == key;
    if (!wanted && item.has(key)) item.find(key)->fail(std::string("it goes with region: ") + shape);
  }
  std::size_t left_out = 3;
  if (axis_key) left_out = item.choice(axis_key, {"x", "y", "z"});

  const bool turns = region.shape == Shape::cone;
  const Quantity& quantity = turns ? quantity::angle : quantity::length;
  region.radius = item.number("tolerance", quantity, Range::positive());
  if (const auto distribution = item.find("distribution")) readSpread(*distribution, region);
  if (context.faults.count() > before) return;

  for (std::size_t i = 0; i < 3; ++i) {
    if (i == left_out) continue;
    DesignVariable variable;
    variable.name = region.name + (turns ? "_r" : "_") + kAxisNames[i];
    variable.target = targetOf(of_clip, region.shape, moved, static_cast<Axis>(i));
    variable.unit = quantity.unit;
    variable.lower = -region.radius;
    variable.upper = region.radius;
    variable.distribution = shapeName->text();
    if (!region.uniform) variable.distribution_parameters["sigma"] = region.sigma;
    region.variables.push_back(context.scene.design_variables.size());
    context.design_variables.declare(item, variable.name);
    context.scene.design_variables.push_back(std::move(variable));
  }
  context.scene.tolerance_regions.push_back(std::move(region));
}

}  // namespace cable_variation
