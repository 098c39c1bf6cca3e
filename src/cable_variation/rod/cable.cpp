#include <cable_variation/rod/cable.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace cable_variation {
namespace {

template <class... Parts>
[[noreturn]] void refuse(const Cable& cable, const Parts&... parts) {
  std::ostringstream text;
  text << "cable '" << cable.name << "': ";
  (text << ... << parts);
  throw std::invalid_argument(text.str());
}

template <class Knots>
void validateKnots(const Cable& cable, const Knots& knots, const char* what) {
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double s = knots[i].arc_length;
    if (!(s >= 0.0 && s <= cable.length * (1.0 + 1e-9))) {
      refuse(cable, what, " ", i, " is at ", s, " m, expected between 0 and the length of ", cable.length,
             " m");
    }
    if (i > 0 && s < knots[i - 1].arc_length) {
      refuse(cable, what, " ", i, " is at ", s, " m, expected not before the previous one at ",
             knots[i - 1].arc_length, " m");
    }
  }
}

}  // namespace

Section sectionAt(const Cable& cable, double arc_length) {
  const auto& knots = cable.sections;
  const double s = std::clamp(arc_length, 0.0, cable.length);
  if (s <= knots.front().arc_length) return knots.front().section;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double step = knots[i].arc_length - knots[i - 1].arc_length;
    if (s < knots[i].arc_length && step > 0.0) {
      return interpolate(knots[i - 1].section, knots[i].section, (s - knots[i - 1].arc_length) / step);
    }
  }
  return knots.back().section;
}

double massOf(const Cable& cable) {
  const std::vector<SectionAt>& sections = cable.sections;
  if (sections.size() == 1) return sections.front().section.mass_per_length * cable.length;
  // Linear between the sections, constant before the first and after the last.
  double mass = sections.front().section.mass_per_length * sections.front().arc_length +
                sections.back().section.mass_per_length * (cable.length - sections.back().arc_length);
  for (std::size_t i = 1; i < sections.size(); ++i) {
    const double span = sections[i].arc_length - sections[i - 1].arc_length;
    mass += 0.5 * span * (sections[i - 1].section.mass_per_length + sections[i].section.mass_per_length);
  }
  return mass;
}

void validate(const Cable& cable) {
  if (!(std::isfinite(cable.length) && cable.length > 0.0)) {
    refuse(cable, "length is ", cable.length, " m, expected a positive number");
  }
  if (cable.sections.empty()) refuse(cable, "has no section, expected at least one");
  validateKnots(cable, cable.sections, "section");
  validateKnots(cable, cable.rest_curvature, "rest curvature");
  for (const SectionAt& at : cable.sections) {
    try {
      validate(at.section);
    } catch (const std::invalid_argument& error) {
      refuse(cable, error.what());
    }
    if (at.section.radius >= cable.length) {
      refuse(cable, "radius is ", at.section.radius, " m, expected less than the length of ", cable.length,
             " m");
    }
  }
  for (std::size_t i = 0; i < cable.rest_curvature.size(); ++i) {
    if (!cable.rest_curvature[i].curvature.allFinite()) refuse(cable, "rest curvature ", i, " is not finite");
  }
  for (std::size_t i = 0; i < cable.via.size(); ++i) {
    if (!cable.via[i].allFinite()) refuse(cable, "via point ", i, " is not finite");
  }
  if (cable.twist && !std::isfinite(*cable.twist)) refuse(cable, "twist is not finite");
}

}  // namespace cable_variation
