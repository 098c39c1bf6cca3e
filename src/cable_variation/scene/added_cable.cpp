#include <cable_variation/scene/added_cable.h>

#include <stdexcept>
#include <utility>

namespace cable_variation {

void addCable(Design& design, Cable cable) {
  Harness& harness = design.scene.harness;
  for (const Cable& other : harness.cables) {
    if (other.name == cable.name)
      throw std::invalid_argument("there is a cable named '" + cable.name + "' already");
  }
  validate(cable);
  harness.cables.push_back(std::move(cable));
}

}  // namespace cable_variation
