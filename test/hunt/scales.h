#pragma once

#include <algorithm>
#include <sstream>
#include <string>

#include <cable_variation/harness/harness.h>

namespace cable_variation::hunt {

/// Parts one after the other, numbers to four figures.
template <class... Parts>
std::string textOf(const Parts&... parts) {
  std::ostringstream text;
  text.precision(4);
  (text << ... << parts);
  return text.str();
}

inline double softestBending(const Cable& cable) {
  const Section& section = cable.sections.front().section;
  return std::min(section.EI_y, section.EI_z);
}

/// Length of the longest cable [m].
inline double longestLength(const Harness& harness) {
  double length = 0.0;
  for (const Cable& cable : harness.cables) length = std::max(length, cable.length);
  return length;
}

/// EI/L of the cable that has most of it [J].
inline double bendingScale(const Harness& harness) {
  double scale = 0.0;
  for (const Cable& cable : harness.cables) scale = std::max(scale, softestBending(cable) / cable.length);
  return scale;
}

/// κ = EA L²/EI, the largest.
inline double slendernessOf(const Harness& harness) {
  double slenderness = 0.0;
  for (const Cable& cable : harness.cables) {
    const double kappa =
        cable.sections.front().section.EA * cable.length * cable.length / softestBending(cable);
    slenderness = std::max(slenderness, kappa);
  }
  return slenderness;
}

}  // namespace cable_variation::hunt
