#include <cable_variation/import/import_finding.h>

namespace cable_variation {

const char* toString(ImportFinding::Kind kind) {
  switch (kind) {
    case ImportFinding::Kind::stale_curve:
      return "stale curve";
    case ImportFinding::Kind::open_curve:
      return "open curve";
    case ImportFinding::Kind::no_curve:
      return "no curve";
    case ImportFinding::Kind::reversed_curve:
      return "reversed curve";
    case ImportFinding::Kind::tight_bend:
      return "tight bend";
    case ImportFinding::Kind::no_length:
      return "no length";
    case ImportFinding::Kind::no_cross_section:
      return "no cross-section";
    case ImportFinding::Kind::thin_cross_section:
      return "thin cross-section";
    case ImportFinding::Kind::short_cable:
      return "short cable";
    case ImportFinding::Kind::cycle:
      return "cycle";
    case ImportFinding::Kind::disconnected:
      return "disconnected";
    case ImportFinding::Kind::not_held:
      return "not held";
    case ImportFinding::Kind::missing_placement:
      return "missing placement";
    case ImportFinding::Kind::far_placement:
      return "far placement";
    case ImportFinding::Kind::unused_fixing:
      return "unused fixing";
    case ImportFinding::Kind::wire_without_route:
      return "wire without route";
    case ImportFinding::Kind::wrong_unit:
      return "wrong unit";
    case ImportFinding::Kind::wire_without_mass:
      return "wire without mass";
    case ImportFinding::Kind::protection_without_mass:
      return "protection without mass";
  }
  return "";
}

}  // namespace cable_variation
