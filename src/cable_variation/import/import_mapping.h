#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <cable_variation/harness/clip.h>
#include <cable_variation/import/bundle_section.h>
#include <cable_variation/import/segment_curve.h>

namespace cable_variation {

/// What a mounted part is to the harness.
struct PartRule {
  std::string clip;           ///< type of its clip, as in a scene file; empty: it holds nothing
  std::string more;           ///< further keys of its clip, as in a scene file: "axis: z"; or empty
  ClipConstraint constraint;  ///< of its clip
  std::string tolerance;      ///< name of a class; empty: none
};

/// Deviations that production makes, as symmetric tolerances; each may be left out.
struct ToleranceClass {
  std::optional<double> translate;   ///< of a clip, along each axis that it holds [m]
  std::optional<double> rotate;      ///< about each such axis [rad]
  std::optional<double> arc_length;  ///< of a clip's place on its cable [m]
  std::optional<double> length;      ///< of a cable [m]
  double sigma = 3.0;                ///< standard deviations from the middle to the limit
};

/// A part of wire by its supplier's table: what is here counts, not what the harness's file says.
struct WireRule {
  std::optional<double> conductor_area;   ///< [m²]
  std::optional<double> diameter;         ///< insulation included [m]
  std::optional<double> mass_per_length;  ///< [kg/m]
  std::optional<double> modulus;          ///< of the conductor when it is drawn [Pa]
  std::optional<double> EI, GJ;           ///< of one wire [N m²]
};

/// Likewise tape or tube: its own stiffness, or that of a tube with this wall around the bundle.
struct ProtectionRule {
  std::optional<double> mass_per_length;     ///< [kg/m]
  std::optional<double> EA, EI, GJ;          ///< [N], [N m²], [N m²]
  std::optional<double> thickness, modulus;  ///< of the wall [m], [Pa]
};

enum class ImportedRestShape {
  straight,  ///< the harness is made straight
  curve      ///< it is made in the form of its centre curves
};

/// What a harness's file does not say: how parts hold it, how stiff bundles are, tolerances.
struct ImportMapping {
  std::map<std::string, PartRule> parts;  ///< by part number
  std::map<std::string, PartRule> types;  ///< by Fixing_type or Usage, or by the element's name
  std::map<std::string, ToleranceClass> tolerances;
  std::string cable_tolerance;                        ///< class of all cables; empty: none
  std::map<std::string, WireRule> wires;              ///< by part number
  std::map<std::string, ProtectionRule> protections;  ///< by part number, or by Protection_type
  BundleRule bundle;
  /// Where between its bounds production makes a bundle: lowest and highest sticking, and how it is spread.
  std::optional<std::array<double, 2>> sticking_range;
  std::string sticking_distribution = "triangular";
  LengthSource length = LengthSource::virtual_length;
  ImportedRestShape rest_shape = ImportedRestShape::straight;
  double least_bend = 2.0;            ///< radius of bends at rest, over the diameter
  double via_spacing = 0.025;         ///< of points on the centre curves [m]
  std::optional<double> route_limit;  ///< of the deviation from the centre curves [m]
  double accuracy = 1e-3;             ///< of the scene [m]
  std::set<std::string> given;        ///< keys above that the file has, "bundle.density" likewise

  /// The rule for a part: by its number, else by its type, else by its element; null: none is there.
  const PartRule* ruleOf(const KblOccurrence& part) const;
  /// Likewise for tape or tube: by its part number, else by its type.
  const ProtectionRule* ruleOf(const KblProtection& protection) const;
};

/// Reads a mapping file (YAML, see doc/import.md). Throws SceneError with all of its faults, each with its
/// line.
ImportMapping readImportMapping(const std::string& path);

/// Likewise a text. @param source path that messages name
ImportMapping readImportMappingText(const std::string& text, const std::string& source);

}  // namespace cable_variation
