#pragma once  // internal to import/

#include <optional>
#include <string>

#include <cable_variation/import/import_finding.h>
#include <cable_variation/import/xml_element.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

/// The value [SI] of a child that is a Numerical_value, {Unit_component, Value_component}, if it is there. A
/// unit of another dimension and a value out of `range` are faults.
std::optional<double> findKblQuantity(const XmlElement& owner, const std::string& name,
                                      const Quantity& quantity, const Range& range);

/// That of Mass_information, per length. Here a unit of another dimension is a finding: files have such.
std::optional<double> findKblMassPerLength(const XmlElement& part, ImportFindings& findings);

/// An area, which no key of a scene file has.
extern const Quantity kKblArea;

}  // namespace cable_variation
