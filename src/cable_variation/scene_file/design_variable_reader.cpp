#include <cmath>
#include <optional>
#include <stdexcept>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/scene/cable_property.h>
#include <cable_variation/scene/design_target.h>
#include <cable_variation/scene_file/distribution_reader.h>
#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {
namespace {

using Property = CableProperty::Property;

// What a variable varies, in which quantity; no quantity after a fault.
struct Target {
  DesignTarget target;
  const Quantity* quantity = nullptr;
  double nominal = 0.0;
};

const Quantity& quantityOf(Property property) {
  switch (property) {
    case Property::length:
    case Property::radius:
      return quantity::length;
    case Property::EI:
    case Property::GJ:
      return quantity::bending_stiffness;
    case Property::EA:
      return quantity::stretch_stiffness;
    case Property::density:
      return quantity::mass_per_length;
    case Property::rest_curvature:
      break;
  }
  return quantity::number;
}

Target readClipTarget(const YamlCursor& item, ReadContext& context) {
  const std::size_t clip = context.clips.find(item, "clip");
  const auto translate = item.find("translate");
  const auto rotate = item.find("rotate");
  const auto property = item.find("property");
  if ((translate ? 1 : 0) + (rotate ? 1 : 0) + (property ? 1 : 0) != 1) {
    item.fail("expected one of translate, rotate and property: arc_length for a clip");
    return {};
  }
  const std::size_t before = context.faults.count();
  Target result;
  if (property) {
    property->choice({"arc_length"});
    result.target = ClipArcLength{clip};
    result.quantity = &quantity::length;
    if (clip != NameTable::npos) {
      const Clip& varied = context.scene.harness.clips[clip];
      result.nominal = varied.arc_length;
      if (varied.constraint.slides) property->fail("the clip slides; its arc length is not a design's");
      if (!isMounted(varied)) property->fail("a free clip holds nothing; it has no arc length to vary");
    }
  } else {
    const auto axis = static_cast<Axis>((translate ? translate : rotate)->choice({"x", "y", "z"}));
    if (translate) {
      result.target = ClipTranslation{clip, axis};
    } else {
      result.target = ClipRotation{clip, axis};
    }
    result.quantity = translate ? &quantity::length : &quantity::angle;
  }
  return clip == NameTable::npos || context.faults.count() > before ? Target() : result;
}

Target readCableTarget(const YamlCursor& item, ReadContext& context) {
  const std::size_t cable = context.cables.find(item, "cable");
  const auto name = item.require("property");
  if (!name) return {};
  const std::size_t before = context.faults.count();
  const auto property = static_cast<Property>(
      name->choice({"length", "radius", "EI", "GJ", "EA", "density", "rest_curvature"}));
  if (cable == NameTable::npos || context.faults.count() > before) return {};

  CableProperty target{cable, property};
  const auto geometric = context.geometric_sections.find(cable);
  if (property == Property::radius) {
    if (geometric == context.geometric_sections.end()) {
      name->fail(
          "the cable has sections both by geometry and by stiffness; expected one kind to vary its radius");
      return {};
    }
    target.similar = geometric->second;
  }
  if (const auto rule = item.find("clips")) {
    if (property != Property::length) rule->fail("it goes with property: length");
    target.clips_scale = rule->choice({"keep", "scale"}) == 1;
  }
  const Cable& varied = context.scene.harness.cables[cable];
  if (varied.sections.empty()) return {};
  if (property == Property::rest_curvature && varied.rest_curvature.empty()) {
    name->fail("the cable has no rest_shape to vary");
    return {};
  }
  const double nominal = propertyOf(varied, property);
  if (!(nominal > 0.0)) {
    if (nominal == 0.0) name->fail("it is 0 at the cable's start; expected more, to scale it");
    return {};
  }
  return {target, &quantityOf(property), nominal};
}

Target readJointTarget(const YamlCursor& item, ReadContext& context) {
  const std::size_t joint = context.joints.find(item, "joint");
  const std::size_t before = context.faults.count();
  item.choice("property", {"arc_length"});
  if (joint == NameTable::npos || context.faults.count() > before) return {};
  return {BreakoutArcLength{joint}, &quantity::length, context.scene.harness.joints[joint].parent_arc_length};
}

Target readComponentTarget(const YamlCursor& item, ReadContext& context) {
  const std::size_t component = context.components.find(item, "component");
  const auto translate = item.find("translate");
  const auto rotate = item.find("rotate");
  const auto locator = item.find("locator");
  if ((translate ? 1 : 0) + (rotate ? 1 : 0) + (locator ? 1 : 0) != 1) {
    item.fail("expected one of translate, rotate and locator for a component");
    return {};
  }
  const std::size_t before = context.faults.count();
  Target result;
  if (locator) {
    const std::size_t index = locator->choice({"0", "1", "2", "3", "4", "5"});
    if (component != NameTable::npos && context.scene.components[component].locators.empty()) {
      locator->fail("component '" + context.components.name(component) + "' has no locators");
    }
    result.target = LocatorDeviation{component, index};
    result.quantity = &quantity::length;
  } else {
    const auto axis = static_cast<Axis>((translate ? translate : rotate)->choice({"x", "y", "z"}));
    if (translate) {
      result.target = ComponentTranslation{component, axis};
    } else {
      result.target = ComponentRotation{component, axis};
    }
    result.quantity = translate ? &quantity::length : &quantity::angle;
  }
  return component == NameTable::npos || context.faults.count() > before ? Target() : result;
}

Target readTarget(const YamlCursor& item, ReadContext& context) {
  struct Kind {
    const char* key;
    std::vector<std::string> keys;
    Target (*read)(const YamlCursor&, ReadContext&);
  };
  static const std::vector<Kind> kinds{
      {"clip", {"translate", "rotate", "property"}, readClipTarget},
      {"cable", {"property", "clips"}, readCableTarget},
      {"joint", {"property"}, readJointTarget},
      {"component", {"translate", "rotate", "locator"}, readComponentTarget}};
  const Kind* found = nullptr;
  for (const Kind& kind : kinds) {
    if (!item.has(kind.key)) continue;
    if (found) {
      item.fail(std::string("'") + found->key + "' and '" + kind.key +
                "' are both there; expected one of them");
      return {};
    }
    found = &kind;
  }
  std::vector<std::string> keys{"name", "tolerance", "distribution"};
  if (!found) {
    keys.insert(keys.end(), {"clip", "cable", "joint", "component", "translate", "rotate", "property",
                             "locator", "clips"});
    if (item.checkKeys(keys)) item.fail("expected one of clip, cable, joint and component");
    return {};
  }
  keys.push_back(found->key);
  keys.insert(keys.end(), found->keys.begin(), found->keys.end());
  item.checkKeys(keys);
  return found->read(item, context);
}

// A deviation; with % a share of the nominal value.
double readDeviation(const YamlCursor& cursor, const Target& target) {
  if (cursor.isScalar() && target.nominal > 0.0) {
    const std::string text = cursor.text();
    if (!text.empty() && text.back() == '%') return target.nominal * cursor.number(quantity::number);
  }
  return cursor.number(*target.quantity);
}

// A symmetric tolerance, or [lower, upper] with lower <= 0 <= upper.
void readTolerance(const YamlCursor& cursor, const Target& target, DesignVariable& variable) {
  if (cursor.isList()) {
    const std::vector<YamlCursor> items = cursor.items(2);
    if (items.size() != 2) return;
    variable.lower = readDeviation(items[0], target);
    variable.upper = readDeviation(items[1], target);
    if (variable.lower > 0.0 || variable.upper < 0.0 || variable.lower == variable.upper) {
      cursor.fail("found " + shortNumber(variable.lower) + " to " + shortNumber(variable.upper) +
                  "; expected [lower, upper] with lower <= 0 <= upper, not both 0");
    }
  } else {
    variable.upper = readDeviation(cursor, target);
    variable.lower = -variable.upper;
    if (variable.upper <= 0.0) {
      cursor.fail("found " + shortNumber(variable.upper) + "; expected more than 0, or [lower, upper]");
    }
  }
}

void readVariable(const YamlCursor& item, DesignVariable& variable, ReadContext& context) {
  if (!item.isMap()) {
    item.checkKeys({"name", "tolerance", "distribution"});
    return;
  }
  const auto tolerance = item.require("tolerance");
  const Target target = readTarget(item, context);
  if (!target.quantity) return;
  variable.target = target.target;
  variable.unit = *target.quantity->unit ? target.quantity->unit : "1";
  variable.nominal = target.nominal;
  for (const DesignVariable& other : context.scene.design_variables) {
    if (!other.unit.empty() && sameQuantity(other.target, variable.target)) {
      item.fail("'" + other.name + "' varies the same");
    }
  }
  if (!tolerance) return;
  const std::size_t before = context.faults.count();
  readTolerance(*tolerance, target, variable);
  if (context.faults.count() > before) return;
  if (const auto distribution = item.find("distribution")) {
    readDistribution(*distribution, *target.quantity, variable, context);
  } else {
    variable.distribution_parameters["sigma"] = 3.0;
  }
}

}  // namespace

void readDesignVariables(const YamlCursor& list, ReadContext& context) {
  for (const YamlCursor& entry : list.items()) {
    if (entry.has("region")) {
      readToleranceRegion(entry, context);
      continue;
    }
    const YamlCursor item = context.design_variables.add(entry);
    DesignVariable variable;
    variable.name = context.design_variables.names().back();
    readVariable(item, variable, context);
    context.scene.design_variables.push_back(std::move(variable));
  }
}

}  // namespace cable_variation
