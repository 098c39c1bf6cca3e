#include <algorithm>
#include <array>
#include <limits>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/scene/measure_traits.h>
#include <cable_variation/scene/moving_components.h>
#include <cable_variation/scene_file/pose_reader.h>
#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {
namespace {

using Keys = std::vector<std::string>;

double largestRadius(const Cable& cable) {
  double radius = 0.0;
  for (const SectionAt& knot : cable.sections) radius = std::max(radius, knot.section.radius);
  return radius;
}

// The cables of a list of names, each once.
std::vector<std::size_t> readCableList(const YamlCursor& list, const ReadContext& context) {
  std::vector<std::size_t> cables;
  const std::vector<YamlCursor> items = list.items();
  if (list.isList() && items.empty()) list.fail("the list is empty; expected a cable at least");
  for (const YamlCursor& item : items) {
    const std::size_t cable = context.cables.find(item);
    if (cable == NameTable::npos) continue;
    if (std::find(cables.begin(), cables.end(), cable) != cables.end()) {
      item.fail("cable '" + context.cables.name(cable) + "' is there twice");
    }
    cables.push_back(cable);
  }
  return cables;
}

// `cable: NAME`, `cables: [NAME, ...]`, or all.
void readCables(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  const auto one = item.find("cable");
  const auto several = item.find("cables");
  if (one && several) several->fail("'cable' is there too; expected one of them");
  if (one) {
    const std::size_t cable = context.cables.find(*one);
    if (cable != NameTable::npos) measure.cables = {cable};
  } else if (several) {
    measure.cables = readCableList(*several, context);
  } else {
    for (std::size_t i = 0; i < context.cables.size(); ++i) measure.cables.push_back(i);
  }
}

// The cable that an arc length is on.
void readOneCable(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  const std::size_t cable = context.cables.find(item, "cable");
  if (cable != NameTable::npos) measure.cables = {cable};
}

double lengthOf(const Measure& measure, const ReadContext& context) {
  return context.cableLength(measure.cables.empty() ? NameTable::npos : measure.cables.front());
}

void readAxis(const YamlCursor& item, Measure& measure) {
  if (const auto axis = item.find("axis")) measure.axis = static_cast<Axis>(axis->choice({"x", "y", "z"}));
}

void readComponentOf(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  readCables(item, measure, context);
  const auto name = item.require("component");
  const std::size_t component = context.components.find(*name);
  if (component != NameTable::npos) {
    measure.component = component;
    const std::vector<std::size_t> bodies = bodiesOf(context.scene, component);
    if (std::all_of(bodies.begin(), bodies.end(),
                    [&](std::size_t body) { return context.scene.components[body].visuals.empty(); })) {
      name->fail("component '" + context.components.name(component) + "' has no shape to measure to");
    }
  }
  measure.skip_near_clips = item.number("skip_near_clips", quantity::length, Range::notNegative(), 0.0);
}

// Four times the sum of the radii for cables that are joined: there they touch by design.
double usualSkipNearJoints(const Measure& measure, const ReadContext& context) {
  constexpr double kRadii = 4.0;
  const std::vector<Cable>& cables = context.scene.harness.cables;
  const auto holds = [](const std::vector<std::size_t>& all, std::size_t one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  };
  double skip = 0.0;
  for (const Joint& joint : context.scene.harness.joints) {
    const bool between = (holds(measure.cables, joint.parent) && holds(measure.other_cables, joint.child)) ||
                         (holds(measure.cables, joint.child) && holds(measure.other_cables, joint.parent));
    if (between) {
      skip =
          std::max(skip, kRadii * (largestRadius(cables[joint.parent]) + largestRadius(cables[joint.child])));
    }
  }
  return skip;
}

void readOtherCables(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  const auto to = item.find("to_cables");
  measure.other_cables = readCableList(*to, context);
  readCables(item, measure, context);
  const auto is_other = [&](std::size_t cable) {
    const auto& others = measure.other_cables;
    return std::find(others.begin(), others.end(), cable) != others.end();
  };
  if (!item.has("cable") && !item.has("cables")) {
    measure.cables.erase(std::remove_if(measure.cables.begin(), measure.cables.end(), is_other),
                         measure.cables.end());
    if (measure.cables.empty() && !measure.other_cables.empty()) {
      to->fail("no cable is left to measure from; expected some of them, not all");
    }
  }
  for (const std::size_t cable : measure.cables) {
    if (is_other(cable)) {
      to->fail("cable '" + context.cables.name(cable) + "' would be measured to itself");
    }
  }
  measure.skip_near_joints = item.number("skip_near_joints", quantity::length, Range::notNegative(),
                                         usualSkipNearJoints(measure, context));
}

void readDistance(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  const bool to_component = item.has("component");
  const bool to_cables = item.has("to_cables");
  if (to_component == to_cables) {
    item.fail(to_cables ? "'component' and 'to_cables' are both there; expected one of them"
                        : "expected 'component' or 'to_cables'");
    return;
  }
  const auto goesWith = [&](const char* key, const char* what) {
    if (item.has(key)) item.find(key)->fail(std::string("it goes with ") + what);
  };
  if (to_component) {
    goesWith("skip_near_joints", "to_cables");
    readComponentOf(item, measure, context);
  } else {
    goesWith("skip_near_clips", "a component");
    readOtherCables(item, measure, context);
  }
}

void readSimilarity(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  readCables(item, measure, context);
  measure.surface = item.flag("surface", false);
}

void readPosition(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  readOneCable(item, measure, context);
  if (const auto at = item.require("at")) measure.arc_length = readArcLength(*at, lengthOf(measure, context));
  if (const auto direction = item.require("direction")) measure.direction = readAxisOrDirection(*direction);
}

void readStress(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  readCables(item, measure, context);
  for (const std::size_t cable : measure.cables) {
    for (const SectionAt& knot : context.scene.harness.cables[cable].sections) {
      if (knot.section.young_modulus > 0.0) continue;
      item.fail("cable '" + context.cables.name(cable) +
                "' is given by its stiffness; expected a section with a material, for its stress");
      break;
    }
  }
}

void readSectionLoad(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  const auto at = item.find("at");
  if (at) {
    if (item.has("cables")) item.find("cables")->fail("'at' is on one of them; expected 'cable'");
    if (!item.has("cables")) readOneCable(item, measure, context);
    measure.arc_length = readArcLength(*at, lengthOf(measure, context));
  } else {
    readCables(item, measure, context);
  }
  readAxis(item, measure);
}

void readStretch(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  readOneCable(item, measure, context);
  const double length = lengthOf(measure, context);
  const auto from = item.find("from");
  const auto to = item.find("to");
  measure.from = from ? readArcLength(*from, length) : 0.0;
  measure.to = to ? readArcLength(*to, length) : length;
  if (measure.from >= measure.to) {
    item.fail("it is from " + shortNumber(measure.from) + " m to " + shortNumber(measure.to) +
              " m; expected from < to");
  }
}

void readClipOf(const YamlCursor& item, Measure& measure, const ReadContext& context, bool must_slide) {
  const std::size_t clip = context.clips.find(item, "clip");
  if (clip == NameTable::npos) return;
  measure.clip = clip;
  const Clip& held = context.scene.harness.clips[clip];
  if (!isMounted(held)) item.find("clip")->fail("a free clip holds nothing");
  if (must_slide && isMounted(held) && !held.constraint.slides) {
    item.find("clip")->fail("the cable does not slide through it");
  }
}

void readClipLoad(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  readClipOf(item, measure, context, false);
  readAxis(item, measure);
}

void readSlide(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  readClipOf(item, measure, context, true);
}

// Whether the scene lets a cable touch a component, of a robot any of its links.
bool haveContact(const Scene& scene, std::size_t cable, std::size_t component) {
  const std::vector<std::size_t> bodies = bodiesOf(scene, component);
  for (std::size_t i = 0; i < scene.harness.contacts.size(); ++i) {
    if (scene.harness.contacts[i].cable == cable &&
        std::find(bodies.begin(), bodies.end(), scene.contact_components[i]) != bodies.end())
      return true;
  }
  return false;
}

// Cables that are not named are those that have contact with the component.
void readContactOf(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  readCables(item, measure, context);
  const auto name = item.require("component");
  if (!name) return;
  const std::size_t component = context.components.find(*name);
  if (component == NameTable::npos) return;
  measure.component = component;
  const Scene& scene = context.scene;
  if (!scene.contacts.empty() && scene.harness.contacts.empty()) return;  // it has a fault, which is told
  const auto apart = [&](std::size_t cable) { return !haveContact(scene, cable, component); };
  if (!item.has("cable") && !item.has("cables")) {
    measure.cables.erase(std::remove_if(measure.cables.begin(), measure.cables.end(), apart),
                         measure.cables.end());
    if (measure.cables.empty())
      name->fail("no cable has contact with component '" + context.components.name(component) +
                 "'; expected them in the scene's 'contact'");
  }
  for (const std::size_t cable : measure.cables) {
    if (apart(cable))
      name->fail("cable '" + context.cables.name(cable) + "' has no contact with component '" +
                 context.components.name(component) + "'; expected both in the scene's 'contact'");
  }
}

// Straight from point to point; a place that is there twice has no direction.
void readRoute(const YamlCursor& list, Measure& measure, const ReadContext& context) {
  if (!list.isAtMost(context.limits.via_points, "via_points")) return;
  const std::vector<YamlCursor> items = list.items();
  if (list.isList() && items.size() < 2) list.fail("expected two points at least");
  for (const YamlCursor& item : items) {
    const Eigen::Vector3d point = item.vector(quantity::length);
    if (!measure.route.empty() && point == measure.route.back())
      item.fail("it is the point before again; expected another one");
    measure.route.push_back(point);
  }
}

void readRouteDeviation(const YamlCursor& item, Measure& measure, const ReadContext& context) {
  readStretch(item, measure, context);
  if (const auto route = item.require("route")) readRoute(*route, measure, context);
  if (item.has("segment")) measure.segment = item.text("segment");
}

void readNothing(const YamlCursor&, Measure&, const ReadContext&) {}

// How a measure's type is written: the keys it takes beyond those of all, and how they are read.
struct MeasureForm {
  Measure::Type type;
  std::array<const char*, 6> keys;  // as many as are not null
  void (*read)(const YamlCursor&, Measure&, const ReadContext&);
};

using Type = Measure::Type;
constexpr std::array<MeasureForm, enumeratorCount<Type>()> kForms{{
    {Type::distance,
     {"cable", "cables", "component", "to_cables", "skip_near_clips", "skip_near_joints"},
     readDistance},
    {Type::similarity, {"cable", "cables", "surface"}, readSimilarity},
    {Type::position, {"cable", "at", "direction"}, readPosition},
    {Type::bend_radius, {"cable", "cables"}, readCables},
    {Type::strain, {"cable", "cables"}, readCables},
    {Type::stress, {"cable", "cables"}, readStress},
    {Type::section_force, {"cable", "cables", "at", "axis"}, readSectionLoad},
    {Type::section_moment, {"cable", "cables", "at", "axis"}, readSectionLoad},
    {Type::twist, {"cable", "from", "to"}, readStretch},
    {Type::clip_force, {"clip", "axis"}, readClipLoad},
    {Type::clip_moment, {"clip", "axis"}, readClipLoad},
    {Type::slide, {"clip"}, readSlide},
    {Type::contact_force, {"cable", "cables", "component"}, readContactOf},
    {Type::contact_length, {"cable", "cables", "component"}, readContactOf},
    {Type::route_deviation, {"cable", "from", "to", "route", "segment"}, readRouteDeviation},
    {Type::energy, {}, readNothing},
    {Type::eigenvalue, {}, readNothing},
}};
static_assert(hasRowOfEach(kForms, &MeasureForm::type), "a type of measure has no row, or is out of order");

void readLimits(const YamlCursor& item, const Quantity& quantity, Measure& measure) {
  if (const auto lower = item.find("lower")) measure.lower = lower->number(quantity);
  if (const auto upper = item.find("upper")) measure.upper = upper->number(quantity);
  if (measure.lower && measure.upper && *measure.lower >= *measure.upper) {
    item.fail("limits from " + shortNumber(*measure.lower) + " to " + shortNumber(*measure.upper) +
              "; expected lower < upper");
  }
}

void readMeasure(const YamlCursor& item, Measure& measure, ReadContext& context) {
  if (!item.isMap()) {
    item.checkKeys({"name", "type"});
    return;
  }
  Keys names;
  for (const MeasureTraits& traits : measureTraits()) names.emplace_back(traits.name);
  const auto value = item.require("type");
  if (!value) return;
  const std::size_t before = context.faults.count();
  const std::size_t type = value->choice(names);
  if (context.faults.count() > before) return;
  Keys keys{"name", "type", "lower", "upper"};
  const MeasureForm& form = kForms[type];
  for (const char* key : form.keys) {
    if (key != nullptr) keys.emplace_back(key);
  }
  item.checkKeys(keys);
  measure.type = form.type;
  const Quantity& quantity = *traitsOf(form.type).quantity;
  measure.unit = *quantity.unit ? quantity.unit : "1";
  if (context.cables.size() == 0) {
    item.fail("the scene has no cables to measure");
    return;
  }
  form.read(item, measure, context);
  readLimits(item, quantity, measure);
}

}  // namespace

void readMeasures(const YamlCursor& list, ReadContext& context) {
  readEach(list, context.measures, context.scene.measures,
           [&](const YamlCursor& item, Measure& measure) { readMeasure(item, measure, context); });
}

}  // namespace cable_variation
