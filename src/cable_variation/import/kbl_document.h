#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/import/import_finding.h>
#include <cable_variation/math/pose.h>

namespace cable_variation {

/// What a KBL file (VDA 4964, 2.3 to 2.5) says of a harness's shape, of what it is made of and of what holds
/// it. Lengths are in metres, masses in kilograms; ids are the file's; indices are into the lists of
/// KblDocument. Nothing is mended: what is not there is not there.

/// A position in the vehicle, where segments meet or end.
struct KblNode {
  std::string id;
  std::string name;                                    ///< Id, for people
  int line = 0;                                        ///< in the file, from 1
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  std::vector<std::size_t> occurrences;                ///< Referenced_components that are read
};

/// One piece of a segment's centre curve: a uniform B-spline. The format does not say whether its knots are
/// clamped.
struct KblCurve {
  std::string id;
  int degree = 1;
  std::vector<Eigen::Vector3d> control_points;  ///< [m], more than `degree`
};

/// A fixing's place on a segment.
struct KblFixingPlace {
  std::string id;
  int line = 0;
  double location = 0.0;       ///< share of the segment's length, 0 to 1
  std::size_t occurrence = 0;  ///< what holds it
};

/// Tape or tube over a part of a segment.
struct KblProtectionArea {
  double start = 0.0, end = 1.0;  ///< shares of the segment's length
  std::size_t protection = 0;
};

/// A piece of the harness between two nodes.
struct KblSegment {
  std::string id;
  std::string name;
  int line = 0;
  std::size_t start_node = 0, end_node = 0;
  std::optional<Eigen::Vector3d> start_vector, end_vector;  ///< tangents along it, of length 1
  std::optional<double> virtual_length, physical_length;    ///< [m]
  std::optional<double> area;                               ///< of its cross-section [m²]
  std::vector<KblCurve> curves;                             ///< of its centreline, in order
  std::vector<KblFixingPlace> fixings;
  std::vector<KblProtectionArea> protections;

  /// Of the circle of the cross-section's area [m].
  std::optional<double> diameter() const;
};

/// A part that is mounted: a connector, a terminal, a fixing, a box.
struct KblOccurrence {
  std::string id;
  std::string name;
  int line = 0;
  std::string element;      ///< its kind: "Connector_occurrence"
  std::string part_number;  ///< empty: none
  std::string type;         ///< Usage of a connector, Fixing_type of a fixing; empty: none
  std::string description;
  std::optional<Pose> placement;  ///< axes U, V, U x V
};

/// A part of wire by the metre.
struct KblWirePart {
  std::string id;
  std::string part_number;
  std::optional<double> outside_diameter;  ///< [m]
  std::optional<double> conductor_area;    ///< [m²]; of a multicore wire, the sum of its cores'
  std::optional<double> mass_per_length;   ///< [kg/m]
  std::optional<double> bend_radius;       ///< the smallest allowed [m]
};

/// A wire of the harness, one for all cores of a multicore one.
struct KblWire {
  std::string id;
  std::size_t part = 0;
};

/// The way of one connection's wire, or core, through the harness.
struct KblRouting {
  std::string id;
  int line = 0;
  std::size_t wire = 0;
  std::vector<std::size_t> segments;
};

struct KblProtection {
  std::string id;
  std::string part_number;
  std::string type;                       ///< Protection_type
  std::optional<double> mass_per_length;  ///< [kg/m]
};

struct KblDocument {
  std::string source;       ///< the file
  std::string version;      ///< version_id
  std::string part_number;  ///< of the harness
  std::vector<KblNode> nodes;
  std::vector<KblSegment> segments;
  std::vector<KblOccurrence> occurrences;
  std::vector<KblWirePart> wire_parts;
  std::vector<KblWire> wires;
  std::vector<KblRouting> routings;
  std::vector<KblProtection> protections;
  ImportFindings findings;  ///< of what could be read and is not used
};

/// Reads a file. Throws SceneError with all of its faults, each with its line, the element's id and what was
/// expected: broken XML, ids that are there twice or point nowhere or at something else, values that are no
/// numbers, lengths and areas in other units, segments from a node to itself.
KblDocument readKbl(const std::string& path);

/// Likewise a text that is not in a file. @param source path that messages name
KblDocument readKblText(const std::string& text, const std::string& source);

}  // namespace cable_variation
