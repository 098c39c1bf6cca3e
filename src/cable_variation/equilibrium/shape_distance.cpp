#include <cable_variation/equilibrium/shape_distance.h>

namespace cable_variation {

ShapeDistance shapeDistance(const std::vector<CableShape>& a, const std::vector<CableShape>& b,
                            std::size_t places) {
  ShapeDistance largest;
  for (std::size_t cable = 0; cable < b.size(); ++cable) {
    const std::vector<Pose> on_a = a[cable].sample(places), on_b = b[cable].sample(places);
    for (std::size_t i = 0; i < places; ++i) {
      const double distance = (on_a[i].position - on_b[i].position).norm();
      if (distance <= largest.distance) continue;
      largest = {
          distance, cable,
          b[cable].points.back().arc_length * static_cast<double>(i) / static_cast<double>(places - 1)};
    }
  }
  return largest;
}

}  // namespace cable_variation
