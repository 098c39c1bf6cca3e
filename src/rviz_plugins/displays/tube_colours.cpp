#include <rviz_plugins/displays/tube_colours.h>

#include <algorithm>

#include <ros_interface/markers/marker_colours.h>

namespace cable_variation_rviz {

using cable_variation::CableQuantity;
using cable_variation::CableTube;
using cable_variation::CableTubes;
using Eigen::Vector4f;

namespace {

const CableQuantity* find(const CableTube& tube, const std::string& name) {
  for (const CableQuantity& quantity : tube.quantities) {
    if (quantity.name == name) return &quantity;
  }
  return nullptr;
}

Vector4f ownColour(const CableTubes& tubes, std::size_t index, float alpha) {
  Vector4f color =
      (tubes.outdated ? cable_variation_ros::kOutdatedGrey : cable_variation_ros::cableColour(index))
          .cast<float>();
  color[3] *= alpha;
  return color;
}

}  // namespace

std::optional<QuantityRange> rangeOf(const CableTubes& tubes, const std::string& quantity) {
  std::optional<QuantityRange> range;
  for (const CableTube& tube : tubes.cables) {
    const CableQuantity* found = find(tube, quantity);
    if (found == nullptr) continue;
    if (!range) range = QuantityRange{found->minimum, found->maximum, found->unit};
    range->minimum = std::min<double>(range->minimum, found->minimum);
    range->maximum = std::max<double>(range->maximum, found->maximum);
  }
  return range;
}

std::vector<std::string> quantitiesOf(const CableTubes& tubes) {
  std::vector<std::string> names;
  for (const CableTube& tube : tubes.cables) {
    for (const CableQuantity& quantity : tube.quantities) {
      if (std::find(names.begin(), names.end(), quantity.name) == names.end()) names.push_back(quantity.name);
    }
  }
  return names;
}

std::vector<Vector4f> stationColours(const CableTubes& tubes, std::size_t index,
                                     const TubeColouring& colouring) {
  const CableTube& tube = tubes.cables[index];
  const CableQuantity* quantity = tubes.outdated ? nullptr : find(tube, colouring.quantity);
  if (quantity == nullptr) {
    if (tube.elsewhere) return {};
    return std::vector<Vector4f>(tube.radius.size(), ownColour(tubes, index, colouring.alpha));
  }
  std::vector<Vector4f> colors;
  colors.reserve(quantity->values.size());
  for (const float value : quantity->values) {
    Vector4f color;
    color.head<3>() = mapped(colouring.map, value, colouring.minimum, colouring.maximum).cast<float>();
    color[3] = colouring.alpha;
    colors.push_back(color);
  }
  return colors;
}

}  // namespace cable_variation_rviz
