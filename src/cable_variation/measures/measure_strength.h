#pragma once  // internal to measures/

#include <cable_variation/measures/measure_context.h>

namespace cable_variation {

// What the cable itself bears. Between points of the shape: SectionLoads.

/// Largest normal strain of a section's surface, |stretch| + radius × |bending curvature|, or of a
/// rectangle, |stretch| + ½ height |κ_y| + ½ width |κ_z| (its corner).
/// Stress: E × that with shear G × (distance × |torsion| + |shear strain|) as an equivalent (von Mises)
/// stress; `distance` is the radius, of a rectangle no more than its shorter side. An upper bound, since the
/// largest of each do not meet in one place.
MeasureValue strengthValue(const MeasureContext& context, const Measure& measure);
RateOfMeasure strengthRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value);

/// section_force, section_moment: the magnitude, or the component along an axis of the section; at an arc
/// length (at a clip or joint the side s+), or where it is largest (a component: in magnitude, its sign
/// kept).
MeasureValue sectionLoadValue(const MeasureContext& context, const Measure& measure);
RateOfMeasure sectionLoadRate(const MeasureContext& context, const Measure& measure,
                              const MeasureValue& value);

/// ∫ (Ω_x - Ω₀_x) ds between two arc lengths: how much further than at rest the last section is turned
/// about the tangent.
MeasureValue twistValue(const MeasureContext& context, const Measure& measure);
RateOfMeasure twistRate(const MeasureContext& context, const Measure& measure);

}  // namespace cable_variation
