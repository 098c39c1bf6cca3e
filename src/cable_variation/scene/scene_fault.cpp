#include <cable_variation/scene/scene_fault.h>

namespace cable_variation {

std::string toString(const SceneFault& fault) {
  return fault.file + (fault.line > 0 ? ':' + std::to_string(fault.line) : "") + ": " + fault.message;
}

}  // namespace cable_variation
