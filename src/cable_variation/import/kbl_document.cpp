#include <cable_variation/import/kbl_document.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include <Eigen/Geometry>

#include <cable_variation/import/kbl_quantity.h>
#include <cable_variation/import/xml_element.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/regular_file.h>
#include <cable_variation/util/text_tokens.h>

namespace cable_variation {
namespace {

constexpr std::size_t kMostBytes = 200'000'000;
constexpr double kCoordinateUnit = 1e-3;  // [m]: coordinates are in mm, whatever units the values have
constexpr double kDirectionTolerance = 1e-3;
// What no harness of a vehicle goes beyond, in SI; it keeps what is computed of it finite.
constexpr double kFarthest = 1e6;
constexpr Range kLengths{1e-6, 1e3, false};
constexpr Range kAreas{1e-12, 1.0, false};

using Kinds = std::vector<std::string>;
const Kinds kPoint{"Cartesian_point"};
const Kinds kNode{"Node"};
const Kinds kSegment{"Segment"};
// What is mounted in the vehicle, or sits on the harness, at a node or along a segment.
const Kinds kOccurrences{"Connector_occurrence",     "Special_terminal_occurrence",
                         "Fixing_occurrence",        "Accessory_occurrence",
                         "Component_box_occurrence", "Assembly_part_occurrence",
                         "Component_box_connectors", "Wire_protection_occurrence"};

class KblReader {
 public:
  KblReader(const XmlIds& ids, KblDocument& document) : root_(ids.root(), ids), document_(document) {}

  void read() {
    document_.version = root_.attribute("version_id");
    if (const auto harness = root_.find("Harness")) document_.part_number = harness->textOf("Part_number");
    readWireParts();
    readWires();
    readProtections();
    readOccurrences();
    readNodes();
    readSegments();
    readRoutings();
    if (document_.segments.empty()) root_.fail("there is no Segment; expected one at least");
  }

 private:
  using Indices = std::map<std::string, std::size_t>;  // by id

  static std::optional<std::size_t> indexOf(const std::optional<XmlElement>& element,
                                            const Indices& indices) {
    if (!element) return {};
    const auto found = indices.find(element->id());
    return found == indices.end() ? std::optional<std::size_t>() : found->second;
  }

  // Elements of a kind, each with an id of its own.
  std::vector<XmlElement> all(const std::string& kind) const {
    std::vector<XmlElement> found;
    for (const XmlElement& element : root_.below({kind})) {
      if (element.id().empty()) {
        element.fail("the id is missing");
      } else {
        found.push_back(element);
      }
    }
    return found;
  }

  static Eigen::Vector3d readPoint(const XmlElement& point) {
    const std::vector<double> values = point.numbers("Coordinates", 3);
    if (values.empty()) return Eigen::Vector3d::Constant(NAN);
    const Eigen::Vector3d position = kCoordinateUnit * Eigen::Vector3d(values[0], values[1], values[2]);
    if (position.norm() > kFarthest) {
      point.fail("it is " + shortNumber(position.norm()) + " m from the origin; expected at most " +
                 shortNumber(kFarthest) + " m");
    }
    return position;
  }

  // The point that a child refers to; NaN after a fault.
  static Eigen::Vector3d pointOf(const XmlElement& owner) {
    const auto reference = owner.require("Cartesian_point");
    const auto point = reference ? reference->target(kPoint) : std::nullopt;
    return point ? readPoint(*point) : Eigen::Vector3d::Constant(NAN);
  }

  static std::optional<Eigen::Vector3d> directionOf(const XmlElement& owner, const std::string& name) {
    if (!owner.find(name)) return {};
    const std::vector<double> values = owner.numbers(name, 3);
    if (values.empty()) return {};
    const Eigen::Vector3d direction(values[0], values[1], values[2]);
    if (!(std::abs(direction.norm() - 1.0) < 0.01)) {
      owner.fail(name + " has a length of " + shortNumber(direction.norm()) + "; expected 1");
      return {};
    }
    return Eigen::Vector3d(direction.normalized());
  }

  static std::optional<Pose> placementOf(const XmlElement& owner) {
    const auto placement = owner.find("Placement");
    if (!placement) return {};
    const Eigen::Vector3d position = pointOf(*placement);
    const auto u = directionOf(*placement, "U");
    const auto v = directionOf(*placement, "V");
    if (!u || !v) {
      for (const char* name : {"U", "V"}) {
        if (!placement->find(name)) placement->fail(std::string("'") + name + "' is missing");
      }
      return {};
    }
    if (std::abs(u->dot(*v)) > 10.0 * kDirectionTolerance) {
      placement->fail("U and V are not at right angles, their product is " + shortNumber(u->dot(*v)) +
                      "; expected 0");
      return {};
    }
    Eigen::Matrix3d axes;
    axes.col(0) = *u;
    axes.col(1) = (*v - v->dot(*u) * *u).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return Pose{position, Eigen::Quaterniond(axes).normalized()};
  }

  void readWireParts() {
    for (const XmlElement& element : all("General_wire")) {
      KblWirePart part;
      part.id = element.id();
      part.part_number = element.textOf("Part_number");
      part.outside_diameter = findKblQuantity(element, "Outside_diameter", quantity::length, kLengths);
      part.conductor_area = findKblQuantity(element, "Cross_section_area", kKblArea, kAreas);
      part.mass_per_length = findKblMassPerLength(element, document_.findings);
      part.bend_radius = findKblQuantity(element, "Bend_radius", quantity::length, Range::notNegative());
      for (const XmlElement& core : element.children("Core")) {
        const auto area = findKblQuantity(core, "Cross_section_area", kKblArea, kAreas);
        if (area && !element.find("Cross_section_area"))
          part.conductor_area = part.conductor_area.value_or(0.0) + *area;
      }
      wire_parts_.emplace(part.id, document_.wire_parts.size());
      document_.wire_parts.push_back(std::move(part));
    }
  }

  void readWires() {
    for (const XmlElement& element : all("General_wire_occurrence")) {
      const auto reference = element.require("Part");
      const auto part = indexOf(reference ? reference->target({"General_wire"}) : std::nullopt, wire_parts_);
      if (!part) continue;
      for (const XmlElement& core : element.children("Core_occurrence"))
        wires_.emplace(core.id(), document_.wires.size());
      wires_.emplace(element.id(), document_.wires.size());
      document_.wires.push_back({element.id(), *part});
    }
  }

  void readProtections() {
    for (const XmlElement& element : all("Wire_protection_occurrence")) {
      const auto reference = element.require("Part");
      const auto part = reference ? reference->target({"Wire_protection"}) : std::nullopt;
      if (!part) continue;
      KblProtection protection;
      protection.id = element.id();
      protection.part_number = part->textOf("Part_number");
      protection.type = part->textOf("Protection_type");
      protection.mass_per_length = findKblMassPerLength(*part, document_.findings);
      protections_.emplace(protection.id, document_.protections.size());
      document_.protections.push_back(std::move(protection));
    }
  }

  void readOccurrence(const XmlElement& element) {
    KblOccurrence occurrence;
    occurrence.id = element.id();
    occurrence.line = element.line();
    occurrence.element = element.kind();
    occurrence.name = element.textOf("Id");
    occurrence.type = element.textOf("Usage");
    occurrence.description = element.textOf("Description");
    occurrence.placement = placementOf(element);
    if (const auto reference = element.require("Part")) {
      const auto part = reference->target({"Connector_housing", "General_terminal", "Fixing", "Accessory",
                                           "Component_box", "Assembly_part", "Cavity_plug"});
      if (part) {
        occurrence.part_number = part->textOf("Part_number");
        if (occurrence.type.empty()) occurrence.type = part->textOf("Fixing_type");
        if (occurrence.description.empty()) occurrence.description = part->textOf("Description");
      }
    }
    // a box's connectors are where the box is
    if (occurrence.element == "Component_box_occurrence") {
      for (const XmlElement& connector : element.children("Component_box_connectors"))
        occurrences_.emplace(connector.id(), document_.occurrences.size());
    }
    occurrences_.emplace(occurrence.id, document_.occurrences.size());
    document_.occurrences.push_back(std::move(occurrence));
  }

  void readOccurrences() {
    for (const std::string& kind : kOccurrences) {
      if (kind == "Component_box_connectors" || kind == "Wire_protection_occurrence") continue;
      for (const XmlElement& element : all(kind)) {
        // those of an assembly's part are templates: the harness has occurrences of its own for them
        if (element.parent().kind() == "Harness") readOccurrence(element);
      }
    }
  }

  void readNodes() {
    for (const XmlElement& element : all("Node")) {
      KblNode node;
      node.id = element.id();
      node.line = element.line();
      node.name = element.textOf("Id");
      node.position = pointOf(element);
      if (const auto references = element.find("Referenced_components")) {
        for (const XmlElement& component : references->targets(kOccurrences)) {
          if (const auto index = indexOf(component, occurrences_)) node.occurrences.push_back(*index);
        }
      }
      nodes_.emplace(node.id, document_.nodes.size());
      document_.nodes.push_back(std::move(node));
    }
  }

  std::optional<std::size_t> nodeOf(const XmlElement& segment, const std::string& name) const {
    const auto reference = segment.require(name);
    return indexOf(reference ? reference->target(kNode) : std::nullopt, nodes_);
  }

  static std::optional<KblCurve> readCurve(const XmlElement& element) {
    KblCurve curve;
    curve.id = element.id();
    const auto degree = element.require("Degree");
    const auto references = element.require("Control_points");
    if (!degree || !references) return {};
    const double value = degree->number();
    constexpr double kHighestDegree = 25;
    if (!(value >= 1.0 && value <= kHighestDegree && value == std::floor(value))) {
      if (!std::isnan(value))
        degree->fail("found " + shortNumber(value) + "; expected a whole number from 1 to 25");
      return {};
    }
    curve.degree = static_cast<int>(value);
    const std::vector<XmlElement> points = references->targets(kPoint);
    for (const XmlElement& point : points) curve.control_points.push_back(readPoint(point));
    if (curve.control_points.size() <= static_cast<std::size_t>(curve.degree)) {
      references->fail("there are " + std::to_string(curve.control_points.size()) +
                       " control points; expected at least " + std::to_string(curve.degree + 1) +
                       " for degree " + std::to_string(curve.degree));
      return {};
    }
    return curve;
  }

  static double readShare(const XmlElement& owner, const std::string& name) {
    const auto value = owner.require(name);
    const double share = value ? value->number() : NAN;
    if (share < 0.0 || share > 1.0)
      value->fail("found " + shortNumber(share) + "; expected a share of the segment's length, 0 to 1");
    return share;
  }

  void readAttached(const XmlElement& element, KblSegment& segment) const {
    for (const XmlElement& fixing : element.children("Fixing_assignment")) {
      const double location = readShare(fixing, "Location");
      const auto reference = fixing.require("Fixing");
      const auto occurrence =
          indexOf(reference ? reference->target({"Fixing_occurrence", "Accessory_occurrence"}) : std::nullopt,
                  occurrences_);
      if (occurrence) segment.fixings.push_back({fixing.id(), fixing.line(), location, *occurrence});
    }
    for (const XmlElement& area : element.children("Protection_area")) {
      const double start = readShare(area, "Start_location");
      const double end = readShare(area, "End_location");
      const auto reference = area.require("Associated_protection");
      const auto protection =
          indexOf(reference ? reference->target({"Wire_protection_occurrence"}) : std::nullopt, protections_);
      if (protection) segment.protections.push_back({start, end, *protection});
    }
  }

  void readSegments() {
    for (const XmlElement& element : all("Segment")) {
      KblSegment segment;
      segment.id = element.id();
      segment.line = element.line();
      segment.name = element.textOf("Id");
      const auto start = nodeOf(element, "Start_node");
      const auto end = nodeOf(element, "End_node");
      segment.start_vector = directionOf(element, "Start_vector");
      segment.end_vector = directionOf(element, "End_vector");
      segment.virtual_length = findKblQuantity(element, "Virtual_length", quantity::length, kLengths);
      segment.physical_length = findKblQuantity(element, "Physical_length", quantity::length, kLengths);
      if (const auto area = element.find("Cross_section_area_information"))
        segment.area = findKblQuantity(*area, "Area", kKblArea, kAreas);
      for (const XmlElement& curve : element.children("Center_curve")) {
        if (auto piece = readCurve(curve)) segment.curves.push_back(std::move(*piece));
      }
      readAttached(element, segment);
      if (start && end && *start == *end) {
        element.fail("it goes from node '" + document_.nodes[*start].id + "' to itself; expected two nodes");
      }
      segment.start_node = start.value_or(0);
      segment.end_node = end.value_or(0);
      segments_.emplace(segment.id, document_.segments.size());
      document_.segments.push_back(std::move(segment));
    }
  }

  void readRoutings() {
    for (const XmlElement& element : all("Routing")) {
      KblRouting routing;
      routing.id = element.id();
      routing.line = element.line();
      const auto reference = element.require("Routed_wire");
      const auto connection = reference ? reference->target({"Connection"}) : std::nullopt;
      const auto wire_reference = connection ? connection->require("Wire") : std::nullopt;
      const auto wire =
          indexOf(wire_reference ? wire_reference->target({"General_wire_occurrence", "Core_occurrence"})
                                 : std::nullopt,
                  wires_);
      if (const auto references = element.find("Segments")) {
        for (const XmlElement& segment : references->targets(kSegment)) {
          if (const auto index = indexOf(segment, segments_)) routing.segments.push_back(*index);
        }
      }
      if (!wire) continue;
      routing.wire = *wire;
      document_.routings.push_back(std::move(routing));
    }
  }

  XmlElement root_;
  KblDocument& document_;
  Indices wire_parts_, wires_, protections_, occurrences_, nodes_, segments_;
};

}  // namespace

std::optional<double> KblSegment::diameter() const {
  if (!area) return {};
  return 2.0 * std::sqrt(*area / M_PI);
}

KblDocument readKblText(const std::string& text, const std::string& source) {
  FaultList faults(source);
  KblDocument document;
  document.source = source;
  try {
    const XmlIds ids(text, faults);
    const pugi::xml_node root = ids.root();
    if (faults.count() == 0 && localName(root) != "KBL_container") {
      faults.add(root ? ids.lineOf(root) : 0, "the file's element is " +
                                                  quoted(root ? localName(root) : std::string()) +
                                                  "; expected a KBL_container");
    } else if (root) {
      KblReader(ids, document).read();
    }
  } catch (const FaultList::Full&) {
  }
  if (faults.count() > 0) throw SceneError(faults.sorted());
  return document;
}

KblDocument readKbl(const std::string& path) {
  try {
    return readKblText(readWhole(path, kMostBytes), path);
  } catch (const SceneError&) {
    throw;
  } catch (const std::invalid_argument& error) {
    throw SceneError({{path, 0, std::string("the file ") + error.what()}});
  }
}

}  // namespace cable_variation
