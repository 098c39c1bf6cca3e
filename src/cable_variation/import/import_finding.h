#pragma once

#include <string>
#include <vector>

namespace cable_variation {

/// What a person who imports a harness should know: nothing of it is mended.
struct ImportFinding {
  enum class Kind {
    stale_curve,             ///< the centre curve is not of the segment's length, or is elsewhere
    open_curve,              ///< its pieces do not join
    no_curve,                ///< there is none
    reversed_curve,          ///< it runs from the end node to the start node; it is read so
    tight_bend,              ///< it turns on a radius that no such bundle takes
    no_length,               ///< neither a virtual nor a physical length; the curve's is taken
    no_cross_section,        ///< no area; the wires' or a default is taken
    thin_cross_section,      ///< its area is less than that of the wires that are routed through it
    short_cable,             ///< it is shorter than thick: it is drawn thinner
    cycle,                   ///< segments that close a ring
    disconnected,            ///< a part of the harness that no segment joins to the rest
    not_held,                ///< one that nothing holds: left out
    missing_placement,       ///< a mounted part that has no position
    far_placement,           ///< one that is far from where it holds the harness
    unused_fixing,           ///< a fixing that becomes no clip
    wire_without_route,      ///< it counts nowhere
    wrong_unit,              ///< a mass in a unit that it cannot have; it is not used
    wire_without_mass,       ///< the mass of a default is taken
    protection_without_mass  ///< it weighs nothing
  };
  Kind kind = Kind::stale_curve;
  std::string id;       ///< of the element that it is about
  int line = 0;         ///< of the file, from 1; 0: the file as a whole
  std::string message;  ///< with the ids, values and what was done
};

const char* toString(ImportFinding::Kind kind);

using ImportFindings = std::vector<ImportFinding>;

}  // namespace cable_variation
