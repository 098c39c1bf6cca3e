#include <cable_variation/import/kbl_import.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <cable_variation/import/cable_paths.h>
#include <cable_variation/import/cable_route.h>
#include <cable_variation/import/segment_bundles.h>
#include <cable_variation/import/segment_route.h>
#include <cable_variation/math/so3.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/scene_file/value_text.h>
#include <cable_variation/util/input_limits.h>
#include <cable_variation/util/number_text.h>

namespace cable_variation {
namespace {

using Kind = ImportFinding::Kind;

// A part that is further away from what it holds is told: fixings lie beside the harness, by less than this.
constexpr double kFarAway = 0.05;  // [m]

std::string millimetres(double metres) { return numberText(1e3 * metres, 4) + " mm"; }

// Names of one kind of thing, each given once.
class Names {
 public:
  explicit Names(std::set<std::string> taken = {}) : taken_(std::move(taken)) {}

  std::string give(const std::string& text) {
    const std::string wanted = sceneName(text);
    std::string name = wanted;
    for (int i = 2; !taken_.insert(name).second; ++i) name = wanted + "_" + std::to_string(i);
    return name;
  }

 private:
  std::set<std::string> taken_;
};

// Where something sits on a cable.
struct Place {
  std::size_t path = 0;
  double at = 0.0;  // [m]
};

class KblImport {
 public:
  KblImport(const KblDocument& document, const ImportMapping& mapping)
      : document_(document), mapping_(mapping) {
    requireSize();
    result_.findings = document.findings;
    shapes_.curves = soundCurves(document, result_.findings);
    shapes_.lengths = segmentLengths(document, shapes_.curves, mapping.length);
    bundles_ = segmentBundles(document, mapping, result_.findings);
    reportTightBends();
    makeGraph();
    reportRings();
    paths_ = cablePaths(graph_);
    for (const CablePath& path : paths_.paths)
      routes_.emplace_back(document, shapes_, path, mapping.via_spacing);
    placeNodes();
  }

  ImportResult make() {
    makeClips();
    chooseHeld();
    makeCables();
    makeJoints();
    keepHeldClips();
    makeVariables();
    makeBundleVariables();
    makeRoutes();
    listDefaults();
    writeHead();
    return std::move(result_);
  }

 private:
  void find(Kind kind, const std::string& id, int line, const std::string& message) {
    result_.findings.push_back({kind, id, line, message});
  }

  // A scene holds so much.
  void requireSize() const {
    const InputLimits limits;
    std::size_t held = 0;
    for (const KblNode& node : document_.nodes) held += node.occurrences.size();
    for (const KblSegment& segment : document_.segments) held += segment.fixings.size();
    std::string fault;
    if (document_.segments.size() > limits.cables) {
      fault = "it has " + std::to_string(document_.segments.size()) + " segments; " +
              atMost(limits.cables, "cables");
    } else if (held > limits.clips) {
      fault =
          "it has " + std::to_string(held) + " parts at nodes and segments; " + atMost(limits.clips, "clips");
    }
    if (!fault.empty()) throw SceneError({{document_.source, 0, fault}});
  }

  void reportTightBends() {
    if (mapping_.rest_shape != ImportedRestShape::curve) return;  // it is made straight
    for (std::size_t i = 0; i < document_.segments.size(); ++i) {
      const KblSegment& segment = document_.segments[i];
      const double least = 2.0 * mapping_.least_bend * bundles_[i].section.radius;
      const double smallest = shapes_.curves[i] ? shapes_.curves[i]->smallestBendRadius() : least;
      if (smallest >= least) continue;
      find(Kind::tight_bend, segment.id, segment.line,
           "Segment '" + segment.id + "': its Center_curve turns on a radius of " + millimetres(smallest) +
               ", with a diameter of " + millimetres(2.0 * bundles_[i].section.radius) +
               "; at rest it is taken to be bent to " + millimetres(least) + " at most");
    }
  }

  void makeGraph() {
    graph_.nodes = document_.nodes.size();
    for (std::size_t i = 0; i < document_.segments.size(); ++i) {
      const KblSegment& segment = document_.segments[i];
      graph_.edges.push_back({segment.start_node, segment.end_node, 2.0 * bundles_[i].section.radius,
                              endTangent(document_, shapes_, i, false),
                              endTangent(document_, shapes_, i, true)});
    }
  }

  std::string idsOf(const std::vector<std::size_t>& segments) const {
    constexpr std::size_t kMost = 40;  // that anybody reads
    std::string ids;
    for (std::size_t i = 0; i < std::min(segments.size(), kMost); ++i)
      ids += (i > 0 ? ", " : "") + document_.segments[segments[i]].id;
    if (segments.size() > kMost) ids += " and " + std::to_string(segments.size() - kMost) + " more";
    return ids;
  }

  void reportRings() {
    constexpr std::size_t kMost = 100;
    const std::vector<std::size_t> closing = closingSegments(graph_);
    for (std::size_t i = 0; i < std::min(closing.size(), kMost); ++i) {
      const KblSegment& segment = document_.segments[closing[i]];
      find(Kind::cycle, segment.id, segment.line,
           "Segment '" + segment.id + "': it closes a ring of segments (" +
               idsOf(ringOf(graph_, closing[i])) + "); a joint closes it in the scene");
    }
    const std::vector<std::vector<std::size_t>> parts = connectedSegments(graph_);
    part_of_.assign(graph_.edges.size(), 0);
    for (std::size_t part = 0; part < parts.size(); ++part) {
      for (const std::size_t segment : parts[part]) part_of_[segment] = part;
      if (part == 0) continue;
      const KblSegment& segment = document_.segments[parts[part].front()];
      find(Kind::disconnected, segment.id, segment.line,
           "Segment '" + segment.id +
               "': nothing joins these segments to the first ones of the file: " + idsOf(parts[part]));
    }
    parts_ = parts;
  }

  // On which cable each node is; a joint's children are there by their ends.
  void placeNodes() {
    nodes_.resize(document_.nodes.size());
    for (std::size_t i = 0; i < paths_.paths.size(); ++i) {
      const CablePath& path = paths_.paths[i];
      for (std::size_t k = 0; k < path.parts.size(); ++k) {
        const KblSegment& segment = document_.segments[path.parts[k].segment];
        const std::size_t before = path.parts[k].reversed ? segment.end_node : segment.start_node;
        const std::size_t behind = path.parts[k].reversed ? segment.start_node : segment.end_node;
        segment_places_[path.parts[k].segment] = {i, k};
        nodes_[before] = Place{i, routes_[i].partStart(k)};
        nodes_[behind] = Place{i, routes_[i].partStart(k + 1)};
      }
    }
    for (const PathJoint& joint : paths_.joints) {
      nodes_[joint.node] = Place{joint.parent, routes_[joint.parent].partStart(joint.parent_before)};
      branches_.insert(joint.node);
    }
  }

  // The component of a part: a frame where it is placed.
  const std::string& componentOf(std::size_t occurrence) {
    const auto known = components_.find(occurrence);
    if (known != components_.end()) return known->second;
    const KblOccurrence& part = document_.occurrences[occurrence];
    const std::string name = component_names_.give(part.name.empty() ? part.id : part.name);
    std::string comment = part.element + " " + part.id;
    if (!part.part_number.empty()) comment += ", part " + part.part_number;
    if (!part.type.empty()) comment += ", " + part.type;
    if (!part.description.empty()) comment += ", " + part.description;
    result_.draft.components.push_back({name, *part.placement, comment});
    return components_.emplace(occurrence, name).first->second;
  }

  // What a part is; without a rule a default, which is listed.
  PartRule ruleOf(const KblOccurrence& part) {
    if (const PartRule* rule = mapping_.ruleOf(part)) return *rule;
    PartRule rule;
    const bool splice = part.type == "splice";
    if (!splice) rule.clip = "fixed";
    std::string who = part.element;
    if (!part.type.empty()) who += " of type " + part.type;
    if (!splice && !part.part_number.empty()) who += ", part " + part.part_number;
    ++default_clips_[who + ": " + (splice ? "no clip" : "clip fixed")];
    return rule;
  }

  // Adds the clip of a part that holds a place; `by` is the element that says so. Whether it did.
  bool addClip(std::size_t occurrence, const Place& place, bool at_branch, const std::string& by) {
    const KblOccurrence& part = document_.occurrences[occurrence];
    if (!part.placement) {
      find(Kind::missing_placement, part.id, part.line,
           part.element + " '" + part.id + "': there is no Placement; it holds nothing, though " + by +
               " refers to it");
      return false;
    }
    PartRule rule = ruleOf(part);
    const Pose pose = routes_[place.path].frameAt(place.at);
    const double away = (part.placement->position - pose.position).norm();
    if (away > kFarAway) {
      find(Kind::far_placement, part.id, part.line,
           part.element + " '" + part.id + "': it is placed " + millimetres(away) +
               " from the centreline where " + by + " says it is");
    }
    if (rule.clip.empty()) return false;
    if (rule.constraint.slides &&
        (at_branch || place.at <= 0.0 || place.at >= routes_[place.path].length())) {
      find(Kind::unused_fixing, part.id, part.line,
           part.element + " '" + part.id + "': a clip '" + rule.clip + "' slides, and at " + by +
               " is an end or a branch; it has no clip");
      return false;
    }
    const double close = 1e-6 * routes_[place.path].length();
    for (const SceneDraft::Clip& other : result_.draft.clips) {
      if (other.cable != place.path || std::abs(other.at - place.at) > close) continue;
      find(Kind::unused_fixing, part.id, part.line,
           part.element + " '" + part.id + "': clip '" + other.name + "' holds the same section at " + by +
               "; it has no clip");
      return false;
    }
    const std::string& component = componentOf(occurrence);
    SceneDraft::Clip clip;
    clip.name = clip_names_.give(component);
    clip.type = rule.clip;
    clip.more = rule.more;
    clip.cable = place.path;
    clip.at = place.at;
    clip.component = component;
    clip.pose = part.placement->inverse() * pose;
    clip.comment = part.id + " at " + by;
    result_.draft.clips.push_back(std::move(clip));
    clip_rules_.push_back(std::move(rule));
    return true;
  }

  void makeClips() {
    for (std::size_t i = 0; i < document_.nodes.size(); ++i) {
      if (!nodes_[i]) continue;
      for (const std::size_t occurrence : document_.nodes[i].occurrences)
        addClip(occurrence, *nodes_[i], branches_.count(i) > 0, "node '" + document_.nodes[i].id + "'");
    }
    for (std::size_t i = 0; i < document_.segments.size(); ++i) {
      for (const KblFixingPlace& fixing : document_.segments[i].fixings) addFixing(i, fixing);
    }
  }

  void addFixing(std::size_t segment, const KblFixingPlace& fixing) {
    const KblOccurrence& part = document_.occurrences[fixing.occurrence];
    const KblSegment& on = document_.segments[segment];
    const std::string by = "Segment '" + on.id + "', Location " + numberText(fixing.location, 6);
    if (!shapes_.curves[segment]) {
      find(Kind::unused_fixing, part.id, part.line,
           part.element + " '" + part.id + "': " + by + " has no sound Center_curve; it has no clip there");
      return;
    }
    const double length = shapes_.lengths[segment];
    const double from_start = fixing.location * length;
    const double close = 1e-6 * length;
    for (const bool end : {false, true}) {  // at a node it is the node's place
      if (std::abs(from_start - (end ? length : 0.0)) > close) continue;
      const std::size_t node = end ? on.end_node : on.start_node;
      addClip(fixing.occurrence, *nodes_[node], branches_.count(node) > 0, by);
      return;
    }
    const auto [path, part_index] = segment_places_.at(segment);
    const bool reversed = paths_.paths[path].parts[part_index].reversed;
    const double at = routes_[path].partStart(part_index) + (reversed ? length - from_start : from_start);
    addClip(fixing.occurrence, {path, at}, false, by);
  }

  // Parts of the harness that nothing holds are left out.
  void chooseHeld() {
    std::vector<bool> held(parts_.size(), false);
    const auto partOf = [&](std::size_t path) { return part_of_[paths_.paths[path].parts.front().segment]; };
    for (std::size_t i = 0; i < result_.draft.clips.size(); ++i) {
      const PartRule& rule = clip_rules_[i];
      const bool holds = rule.clip == "fixed" || rule.constraint.holdsPosition();
      if (holds) held[partOf(result_.draft.clips[i].cable)] = true;
    }
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (held[part]) continue;
      const KblSegment& segment = document_.segments[parts_[part].front()];
      find(Kind::not_held, segment.id, segment.line,
           "Segment '" + segment.id +
               "': nothing holds these segments, they are left out: " + idsOf(parts_[part]));
    }
    if (std::find(held.begin(), held.end(), true) == held.end()) {
      throw SceneError(
          {{document_.source, 0,
            "nothing holds the harness: none of its " + std::to_string(document_.occurrences.size()) +
                " mounted parts has a Placement and is at a node or on a segment with a sound "
                "Center_curve; expected one at least"}});
    }
    cables_.assign(paths_.paths.size(), std::nullopt);
    std::size_t count = 0;
    for (std::size_t i = 0; i < paths_.paths.size(); ++i) {
      if (held[partOf(i)]) cables_[i] = count++;
    }
  }

  void makeCables() {
    Names names;
    for (std::size_t i = 0; i < paths_.paths.size(); ++i) {
      if (!cables_[i]) continue;
      const CablePath& path = paths_.paths[i];
      const CableRoute& route = routes_[i];
      SceneDraft::Cable cable;
      cable.name = names.give(document_.segments[path.parts.front().segment].id);
      cable.length = route.length();
      for (std::size_t k = 0; k < path.parts.size(); ++k) {
        const CablePath::Part& part = path.parts[k];
        const KblSegment& segment = document_.segments[part.segment];
        const SegmentBundle& bundle = bundles_[part.segment];
        cable.parts.push_back({route.partStart(k + 1), bundle.section,
                               segment.id + (part.reversed ? " (reversed)" : "") + ": " +
                                   millimetres(route.partStart(k)) + " to " +
                                   millimetres(route.partStart(k + 1)) + ", " + std::to_string(bundle.wires) +
                                   (bundle.wires == 1 ? " wire" : " wires") + ", " + segment.name});
      }
      keepThin(path, cable);
      addWay(route, cable);
      result_.draft.cables.push_back(std::move(cable));
    }
  }

  // A scene's cables are longer than their radius.
  void keepThin(const CablePath& path, SceneDraft::Cable& cable) {
    constexpr double kShare = 0.9;
    for (std::size_t k = 0; k < cable.parts.size(); ++k) {
      double& radius = cable.parts[k].section.radius;
      if (radius < kShare * cable.length) continue;
      const KblSegment& segment = document_.segments[path.parts[k].segment];
      find(Kind::short_cable, segment.id, segment.line,
           "Segment '" + segment.id + "': it has a radius of " + millimetres(radius) + ", and its cable is " +
               millimetres(cable.length) + " long; its radius is taken to be " +
               millimetres(kShare * cable.length) + ", its stiffness and mass are as they are");
      radius = kShare * cable.length;
    }
  }

  // The route as points to pass, and as the form it is made in; no two places are close to each other.
  void addWay(const CableRoute& route, SceneDraft::Cable& cable) const {
    constexpr double kClose = 2e-4;           // [m]
    constexpr std::size_t kMostPoints = 900;  // a scene file may have 1,000
    const std::vector<CableRoute::Station>& stations = route.stations();
    const std::size_t step = 1 + stations.size() / kMostPoints;
    std::vector<CableRoute::Station> chosen{stations.front()};
    for (std::size_t i = 1; i + 1 < stations.size(); i += step) {
      if (stations[i].arc_length - chosen.back().arc_length < kClose) continue;
      if (route.length() - stations[i].arc_length < kClose) break;
      chosen.push_back(stations[i]);
      cable.via.push_back(stations[i].position);
    }
    chosen.push_back(stations.back());
    if (mapping_.rest_shape != ImportedRestShape::curve || !route.isWhole()) return;
    // Between two places the frame turns by a rotation vector: their mean curvature is that of the middle.
    for (std::size_t i = 0; i + 1 < chosen.size(); ++i) {
      const double width = chosen[i + 1].arc_length - chosen[i].arc_length;
      const Eigen::Vector3d turn = so3::log(chosen[i].orientation.conjugate() * chosen[i + 1].orientation);
      const double at = chosen[i].arc_length + 0.5 * width;
      Eigen::Vector3d curvature(0.0, turn.y() / width, turn.z() / width);
      const auto part = std::find_if(cable.parts.begin(), cable.parts.end() - 1,
                                     [at](const SceneDraft::Part& one) { return one.end >= at; });
      const double most = 1.0 / (2.0 * mapping_.least_bend * part->section.radius);
      if (curvature.norm() > most) curvature *= most / curvature.norm();
      cable.rest_curvature.push_back({at, curvature});
    }
  }

  void makeJoints() {
    Names names;
    for (const PathJoint& joint : paths_.joints) {
      if (!cables_[joint.parent] || !cables_[joint.child]) continue;
      const CableRoute& parent = routes_[joint.parent];
      const CableRoute& child = routes_[joint.child];
      SceneDraft::Joint made;
      made.parent = *cables_[joint.parent];
      made.at = parent.partStart(joint.parent_before);
      made.child = *cables_[joint.child];
      made.child_end = joint.child_end;
      made.name = names.give(document_.nodes[joint.node].id + "_" + result_.draft.cables[made.child].name);
      made.rotation = parent.frameAt(made.at).orientation.conjugate() *
                      child.frameAt(joint.child_end ? child.length() : 0.0).orientation;
      result_.draft.joints.push_back(std::move(made));
    }
  }

  // Clips of cables that are left out go too; the others name cables by their place among those that stay.
  void keepHeldClips() {
    std::vector<SceneDraft::Clip> clips;
    std::vector<PartRule> rules;
    for (std::size_t i = 0; i < result_.draft.clips.size(); ++i) {
      SceneDraft::Clip& clip = result_.draft.clips[i];
      if (!cables_[clip.cable]) continue;
      clip.cable = *cables_[clip.cable];
      clips.push_back(std::move(clip));
      rules.push_back(std::move(clip_rules_[i]));
    }
    result_.draft.clips = std::move(clips);
    clip_rules_ = std::move(rules);
  }

  void addVariable(Names& names, const std::string& name, const std::string& target,
                   const std::string& tolerance, double sigma) {
    result_.draft.variables.push_back(
        {names.give(name), target + ", tolerance: " + tolerance +
                               ", distribution: {type: normal, sigma: " + numberText(sigma, 9) + "}"});
  }

  void makeVariables() {
    Names names;
    constexpr double kDegree = M_PI / 180.0;
    for (std::size_t i = 0; i < result_.draft.clips.size(); ++i) {
      const PartRule& rule = clip_rules_[i];
      const auto tolerance = mapping_.tolerances.find(rule.tolerance);
      if (tolerance == mapping_.tolerances.end()) continue;
      const ToleranceClass& one = tolerance->second;
      const std::string clip = result_.draft.clips[i].name;
      const std::string target = "clip: \"" + clip + "\"";
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string x(1, "xyz"[axis]);
        const bool along = rule.constraint.slides && axis == 0;
        if (one.translate && !along && rule.constraint.translation[axis].kind != ClipFreedom::Kind::free)
          addVariable(names, clip + "_" + x, target + ", translate: " + x, lengthText(*one.translate),
                      one.sigma);
        if (one.rotate && rule.constraint.rotation[axis].kind != ClipFreedom::Kind::free)
          addVariable(names, clip + "_r" + x, target + ", rotate: " + x,
                      numberText(*one.rotate / kDegree, 9) + " deg", one.sigma);
      }
      const SceneDraft::Clip& made = result_.draft.clips[i];
      const double length = result_.draft.cables[made.cable].length;
      const bool inside = one.arc_length && made.at > *one.arc_length && made.at < length - *one.arc_length;
      if (inside && !rule.constraint.slides)
        addVariable(names, clip + "_at", target + ", property: arc_length", lengthText(*one.arc_length),
                    one.sigma);
    }
    const auto tolerance = mapping_.tolerances.find(mapping_.cable_tolerance);
    if (tolerance == mapping_.tolerances.end() || !tolerance->second.length) return;
    for (const SceneDraft::Cable& cable : result_.draft.cables) {
      if (*tolerance->second.length >= cable.length) continue;
      addVariable(names, cable.name + "_length",
                  "cable: \"" + cable.name + "\", property: length, clips: scale",
                  lengthText(*tolerance->second.length), tolerance->second.sigma);
    }
  }

  // EI and GJ of each cable between what its first bundle has where wires stick least and most.
  void makeBundleVariables() {
    if (!mapping_.sticking_range) return;
    Names names;
    for (std::size_t i = 0; i < paths_.paths.size(); ++i) {
      if (!cables_[i]) continue;
      const SegmentBundle& bundle = bundles_[paths_.paths[i].parts.front().segment];
      const Section low = sectionBetween(bundle.bounds, (*mapping_.sticking_range)[0]);
      const Section high = sectionBetween(bundle.bounds, (*mapping_.sticking_range)[1]);
      const std::string& cable = result_.draft.cables[*cables_[i]].name;
      for (const auto& [property, of] :
           {std::pair<const char*, double Section::*>("EI", &Section::EI_y), {"GJ", &Section::GJ}}) {
        const double lower = low.*of - bundle.section.*of, upper = high.*of - bundle.section.*of;
        if (!(upper > lower)) continue;
        result_.draft.variables.push_back(
            {names.give(cable + "_" + property),
             "cable: \"" + cable + "\", property: " + property + ", tolerance: [" + numberText(lower, 9) +
                 " N m^2, " + numberText(upper, 9) +
                 " N m^2], distribution: {type: " + mapping_.sticking_distribution + "}"});
      }
    }
  }

  // A measure for each segment in the scene whose curve is sound.
  void makeRoutes() {
    constexpr double kTolerance = 1e-4;        // of the points from the curve [m]
    constexpr double kShortest = 1e-5;         // that is a stretch [m]
    constexpr std::size_t kMostPoints = 1000;  // of a scene file
    Names names;
    for (std::size_t i = 0; i < document_.segments.size(); ++i) {
      const auto place = segment_places_.find(i);
      if (!shapes_.curves[i] || place == segment_places_.end() || !cables_[place->second.first]) continue;
      const auto [path, part] = place->second;
      SceneDraft::Route route;
      route.segment = document_.segments[i].id;
      route.cable = *cables_[path];
      route.from = routes_[path].partStart(part);
      route.to = routes_[path].partStart(part + 1);
      route.limit = mapping_.route_limit;
      double tolerance = kTolerance;
      do {
        route.points = routePoints(*shapes_.curves[i], tolerance);
        tolerance *= 2.0;
      } while (route.points.size() > kMostPoints);
      if (route.points.size() < 2 || route.to - route.from < kShortest) continue;
      if (paths_.paths[path].parts[part].reversed) std::reverse(route.points.begin(), route.points.end());
      route.name = names.give(route.segment);
      result_.draft.routes.push_back(std::move(route));
    }
  }

  void listDefaults() {
    for (const auto& [what, count] : default_clips_)
      result_.defaults.push_back(what + " (" + std::to_string(count) + " times)");
    const BundleRule& rule = mapping_.bundle;
    const auto number = [](double value) { return numberText(value, 6); };
    const std::vector<std::pair<std::string, std::string>> values{
        {"bundle.conductor_modulus", number(1e-9 * rule.conductor_modulus) + " GPa"},
        {"bundle.bending_modulus", number(1e-9 * rule.bending_modulus) + " GPa"},
        {"bundle.sticking", number(rule.sticking)},
        {"bundle.poisson_ratio", number(rule.poisson_ratio)},
        {"bundle.density", number(rule.density) + " kg/m^3"},
        {"bundle.conductor_share", number(rule.conductor_share)},
        {"bundle.wire_area", number(1e6 * rule.wire_area) + " mm^2"},
        {"length", mapping_.length == LengthSource::virtual_length ? "virtual" : "physical"},
        {"rest_shape", mapping_.rest_shape == ImportedRestShape::straight ? "straight" : "curve"},
        {"least_bend", number(mapping_.least_bend)},
        {"via_spacing", millimetres(mapping_.via_spacing)},
        {"accuracy", millimetres(mapping_.accuracy)},
    };
    for (std::size_t i = 0; i < paths_.paths.size() && mapping_.rest_shape == ImportedRestShape::curve; ++i) {
      if (cables_[i] && !routes_[i].isWhole())
        result_.defaults.push_back("rest_shape of cable " + result_.draft.cables[*cables_[i]].name +
                                   ": straight, not all of its segments have a sound Center_curve");
    }
    for (const auto& [key, value] : values) {
      if (mapping_.given.count(key) == 0) result_.defaults.push_back(key + ": " + value);
    }
  }

  void writeHead() {
    std::vector<std::string>& head = result_.draft.head;
    result_.draft.accuracy = mapping_.accuracy;
    head.push_back("Imported from " + document_.source + ", KBL " + document_.version + ", harness " +
                   document_.part_number + ".");
    head.push_back(std::to_string(document_.segments.size()) + " segments became " +
                   std::to_string(result_.draft.cables.size()) + " cables with " +
                   std::to_string(result_.draft.joints.size()) + " joints and " +
                   std::to_string(result_.draft.clips.size()) + " clips.");
    if (!result_.findings.empty()) head.insert(head.end(), {"", "What was found:"});
    for (const ImportFinding& finding : result_.findings)
      head.push_back(std::string(toString(finding.kind)) + ": " + finding.message);
    if (!result_.defaults.empty())
      head.insert(head.end(), {"", "What the mapping does not say, and was taken:"});
    for (const std::string& value : result_.defaults) head.push_back("default: " + value);
  }

  const KblDocument& document_;
  const ImportMapping& mapping_;
  ImportResult result_;
  SegmentShapes shapes_;
  std::vector<SegmentBundle> bundles_;
  SegmentGraph graph_;
  std::vector<std::vector<std::size_t>> parts_;  // connected segments
  std::vector<std::size_t> part_of_;             // per segment
  CablePaths paths_;
  std::vector<CableRoute> routes_;           // per path
  std::vector<std::optional<Place>> nodes_;  // nothing: no segment ends there
  std::set<std::size_t> branches_;           // nodes with joints
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> segment_places_;  // path and part
  std::map<std::size_t, std::string> components_;                              // by occurrence
  std::vector<PartRule> clip_rules_;                                           // per clip
  std::map<std::string, int> default_clips_;
  std::vector<std::optional<std::size_t>> cables_;  // per path, among those that are held
  Names component_names_{{"world"}};
  Names clip_names_;
};

}  // namespace

ImportResult importKbl(const KblDocument& document, const ImportMapping& mapping) {
  return KblImport(document, mapping).make();
}

}  // namespace cable_variation
