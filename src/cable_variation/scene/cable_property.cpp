#include <cable_variation/scene/cable_property.h>

#include <cmath>
#include <stdexcept>

#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

using Property = CableProperty::Property;

const char* nameOf(Property property) {
  switch (property) {
    case Property::length:
      return "length";
    case Property::radius:
      return "radius";
    case Property::EI:
      return "EI";
    case Property::GJ:
      return "GJ";
    case Property::EA:
      return "EA";
    case Property::density:
      return "density";
    case Property::rest_curvature:
      break;
  }
  return "rest_curvature";
}

// Visits the arc length of everything that sits on the cable.
template <typename Visit>
void visitAttached(Harness& harness, std::size_t cable, const Visit& visit) {
  for (Clip& clip : harness.clips) {
    if (clip.cable == cable) visit(clip.arc_length);
  }
  for (Joint& joint : harness.joints) {
    if (joint.parent == cable) visit(joint.parent_arc_length);
    if (joint.child == cable) visit(joint.child_arc_length);
  }
  for (PointLoad& load : harness.loads) {
    if (load.cable == cable) visit(load.arc_length);
  }
}

Eigen::Vector3d curvatureAt(const std::vector<RestCurvatureAt>& knots, double arc_length) {
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double step = knots[i].arc_length - knots[i - 1].arc_length;
    if (arc_length >= knots[i - 1].arc_length && arc_length < knots[i].arc_length && step > 0.0) {
      const double t = (arc_length - knots[i - 1].arc_length) / step;
      return (1.0 - t) * knots[i - 1].curvature + t * knots[i].curvature;
    }
  }
  return arc_length < knots.front().arc_length ? knots.front().curvature : knots.back().curvature;
}

// Removes the knots beyond `length`, leaving `last` there.
template <typename Knot>
void cutOff(std::vector<Knot>& knots, double length, const Knot& last) {
  if (knots.empty() || knots.back().arc_length <= length) return;
  while (!knots.empty() && knots.back().arc_length > length) knots.pop_back();
  knots.push_back(last);
}

void setLength(Harness& harness, std::size_t index, double length, bool scale) {
  Cable& cable = harness.cables[index];
  const double old_length = cable.length;
  const double factor = length / old_length;
  visitAttached(harness, index, [&](double& arc_length) {
    if (arc_length >= old_length) {
      arc_length = length;
    } else if (scale) {
      arc_length *= factor;
    }
  });
  if (scale) {
    for (SectionAt& knot : cable.sections) knot.arc_length = std::min(knot.arc_length * factor, length);
    for (RestCurvatureAt& knot : cable.rest_curvature) {
      knot.arc_length = std::min(knot.arc_length * factor, length);
      knot.curvature /= factor;
    }
  } else {
    const SectionAt last_section{length, sectionAt(cable, length)};
    cutOff(cable.sections, length, last_section);
    if (!cable.rest_curvature.empty()) {
      const RestCurvatureAt last{length, curvatureAt(cable.rest_curvature, length)};
      cutOff(cable.rest_curvature, length, last);
    }
  }
  cable.length = length;
}

void scaleSection(Section& section, const CableProperty& target, double factor) {
  switch (target.property) {
    case Property::radius:
      section.radius *= factor;
      section.width *= factor;
      section.height *= factor;
      if (target.similar) {
        const double area = factor * factor;
        const double inertia = area * area;
        section.EA *= area;
        section.GA_y *= area;
        section.GA_z *= area;
        section.mass_per_length *= area;
        section.GJ *= inertia;
        section.EI_y *= inertia;
        section.EI_z *= inertia;
      }
      break;
    case Property::EI:
      section.EI_y *= factor;
      section.EI_z *= factor;
      break;
    case Property::GJ:
      section.GJ *= factor;
      break;
    case Property::EA:
      section.EA *= factor;
      break;
    case Property::density:
      section.mass_per_length *= factor;
      break;
    case Property::length:
    case Property::rest_curvature:
      break;
  }
}

}  // namespace

double propertyOf(const Cable& cable, Property property) {
  const Section& section = cable.sections.front().section;
  switch (property) {
    case Property::length:
      return cable.length;
    case Property::radius:
      return section.radius;
    case Property::EI:
      return section.EI_y;
    case Property::GJ:
      return section.GJ;
    case Property::EA:
      return section.EA;
    case Property::density:
      return section.mass_per_length;
    case Property::rest_curvature:
      break;
  }
  return 1.0;
}

void setProperty(Harness& harness, const CableProperty& target, double value, double nominal) {
  Cable& cable = harness.cables[target.cable];
  const bool may_be_zero = target.property == Property::density;
  const bool may_be_any = target.property == Property::rest_curvature;
  const Range range = may_be_any ? Range::any() : may_be_zero ? Range::notNegative() : Range::positive();
  if (!range.holds(value)) {
    throw std::invalid_argument("cable '" + cable.name + "': " + nameOf(target.property) + " " +
                                shortNumber(value) + "; expected " + range.text(""));
  }
  if (target.property == Property::length) {
    setLength(harness, target.cable, value, target.clips_scale);
    return;
  }
  const double factor = value / nominal;
  if (target.property == Property::rest_curvature) {
    for (RestCurvatureAt& knot : cable.rest_curvature) knot.curvature *= factor;
  }
  for (SectionAt& knot : cable.sections) scaleSection(knot.section, target, factor);
}

}  // namespace cable_variation
