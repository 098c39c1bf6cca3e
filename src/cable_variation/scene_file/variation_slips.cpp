#include <algorithm>
#include <cmath>
#include <variant>

#include <cable_variation/scene/measure_traits.h>
#include <cable_variation/scene_file/slip_checks.h>

namespace cable_variation {
namespace {

constexpr double kMostTurn = M_PI;            // [rad], of a tolerance: either way that is everything
constexpr double kMostBareTurn = M_PI / 6.0;  // likewise without a unit
constexpr double kBareShare = 0.1;            // of the thing's length, of a tolerance without a unit
constexpr double kBundle = 20.0;              // of the nominal EI or GJ, of a tolerance
constexpr double kLeastBare = 0.1;            // [m], of such a tolerance: the smallest that is usual in mm

// What a tolerance is of: a phrase for it, and its measure in the variable's unit.
struct Reference {
  std::string text;
  double measure = 0.0;
};

class ReferenceOf {
 public:
  ReferenceOf(const Scene& scene, const DesignVariable& variable) : scene_(scene), variable_(variable) {}

  Reference operator()(const ClipTranslation& target) const {
    return cable(scene_.harness.clips[target.clip].cable);
  }
  Reference operator()(const ClipArcLength& target) const {
    return cable(scene_.harness.clips[target.clip].cable);
  }
  Reference operator()(const BreakoutArcLength& target) const {
    return cable(scene_.harness.joints[target.joint].parent);
  }
  Reference operator()(const CableProperty& target) const {
    const std::string unit = variable_.unit == "1" ? "" : " " + variable_.unit;
    // a bundle whose wires stick may be many times as stiff as one whose wires slip
    const bool of_bundle =
        target.property == CableProperty::Property::EI || target.property == CableProperty::Property::GJ;
    return {"on a nominal value of " + shortNumber(variable_.nominal) + unit,
            (of_bundle ? kBundle : 1.0) * variable_.nominal};
  }
  Reference operator()(const ComponentTranslation& target) const { return component(target.component); }
  Reference operator()(const LocatorDeviation& target) const { return component(target.component); }
  Reference operator()(const ClipRotation&) const { return {}; }
  Reference operator()(const ComponentRotation&) const { return {}; }

 private:
  Reference cable(std::size_t index) const {
    const Cable& one = scene_.harness.cables[index];
    return {"on cable '" + one.name + "' of " + shortNumber(one.length) + " m", one.length};
  }
  Reference component(std::size_t index) const {
    const double size = sizeOf(scene_.components[index]).norm();
    const double longest = longestCable(scene_);
    if (size >= longest && size > 0.0) return {"on a component of " + shortNumber(size) + " m", size};
    return {"where the longest cable has " + shortNumber(longest) + " m", longest};
  }

  const Scene& scene_;
  const DesignVariable& variable_;
};

void checkAngle(const YamlCursor& number, double deviation) {
  const bool bare = number.isBareNumber();
  const double angle = std::abs(deviation);
  if (angle <= (bare ? kMostBareTurn : kMostTurn)) return;
  if (bare && angle > 2.0 * M_PI) return;  // told where it was read
  number.warn(number.found() + ", which is " + shortNumber(angle) + " rad or " +
              shortNumber(angle * 180.0 / M_PI) + " deg either way" +
              (bare ? "; in deg?" : "; is that meant?"));
}

void checkDeviation(const YamlCursor& number, double deviation, const Reference& reference,
                    const DesignVariable& variable) {
  if (!(reference.measure > 0.0)) return;
  const bool bare = number.isBareNumber();
  const double size = std::abs(deviation);
  const bool odd_bare =
      bare && variable.unit == "m" && size >= kLeastBare && size > kBareShare * reference.measure;
  if (size <= reference.measure && !odd_bare) return;
  number.warn(number.foundAs(size, variable.unit) + ", " + reference.text +
              (bare ? (variable.unit == "m" ? "; in mm?" : "; in %?") : "; is that meant?"));
}

void checkTolerance(const YamlCursor& number, double deviation, const DesignVariable& variable,
                    const Scene& scene) {
  if (variable.unit == "rad") {
    checkAngle(number, deviation);
  } else {
    checkDeviation(number, deviation, std::visit(ReferenceOf(scene, variable), variable.target), variable);
  }
}

// A limit of a measure, or what it leaves out, that no cable of the scene comes near to.
void checkBareLength(const YamlCursor& number, double longest) {
  if (!number.isBareNumber()) return;
  const double value = number.number(quantity::length);
  if (!(std::abs(value) > longest)) return;
  number.warn(number.found() + " without a unit, which is " + shortNumber(value) +
              " m, where the longest cable has " + shortNumber(longest) + " m; in mm?");
}

void checkLimit(const YamlCursor& number, const Measure& measure, double longest) {
  constexpr double kLeastStress = 1e3;  // [Pa] that anybody would limit
  if (!number.isBareNumber()) return;
  switch (traitsOf(measure.type).unlikely) {
    case MeasureTraits::UnlikelyLimit::none:
      return;
    case MeasureTraits::UnlikelyLimit::longer_than_cables:
      checkBareLength(number, longest);
      return;
    case MeasureTraits::UnlikelyLimit::from_one:
      if (const double value = number.number(quantity::number); value >= 1.0) {
        number.warn(number.found() + ", which is " + shortNumber(100.0 * value) + " %; in %?");
      }
      return;
    case MeasureTraits::UnlikelyLimit::below_a_kilopascal:
      if (const double value = number.number(quantity::stress); value > 0.0 && value < kLeastStress) {
        number.warn(number.found() + " without a unit, which is " + shortNumber(value) + " Pa; in MPa?");
      }
      return;
  }
}

}  // namespace

void checkTolerances(const YamlCursor& root, const Scene& scene) {
  std::size_t variable = 0;
  for (const YamlCursor& item : namedItems(root, "design_variables", "design variable")) {
    const bool is_region = item.has("region");
    const auto tolerance =
        (is_region ? item.labelled("tolerance region '" + item.text("name") + "'") : item).find("tolerance");
    const DesignVariable& first = scene.design_variables[variable];
    if (is_region) {
      checkTolerance(*tolerance, first.upper, first, scene);
      const auto region = std::find_if(scene.tolerance_regions.begin(), scene.tolerance_regions.end(),
                                       [&](const ToleranceRegion& one) {
                                         return !one.variables.empty() && one.variables.front() == variable;
                                       });
      variable += region->variables.size();
      continue;
    }
    if (tolerance->isList()) {
      const std::vector<YamlCursor> limits = tolerance->items();
      checkTolerance(limits[0], first.lower, first, scene);
      checkTolerance(limits[1], first.upper, first, scene);
    } else {
      checkTolerance(*tolerance, first.upper, first, scene);
    }
    ++variable;
  }
}

void checkLimits(const YamlCursor& root, const Scene& scene) {
  const double longest = longestCable(scene);
  const std::vector<YamlCursor> items = namedItems(root, "measures", "measure");
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (const char* key : {"lower", "upper"}) {
      if (const auto limit = items[i].find(key)) checkLimit(*limit, scene.measures[i], longest);
    }
    for (const char* key : {"skip_near_clips", "skip_near_joints"}) {
      if (const auto skip = items[i].find(key)) checkBareLength(*skip, longest);
    }
  }
}

}  // namespace cable_variation
