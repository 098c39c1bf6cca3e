#include <cable_variation/contact/part_surface.h>

#include <limits>
#include <optional>
#include <utility>

#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/geometry/tube_distance/surface_places.h>

namespace cable_variation {
namespace {

class PartSurface : public ContactSurface {
 public:
  explicit PartSurface(std::shared_ptr<const DistancePart> part) : part_(std::move(part)) {}

  void placesNear(const Eigen::Vector3d& x, double within, std::vector<SurfacePlace>& places) const override {
    cable_variation::placesNear(*part_, x, within, places);
  }

  double distance(const Eigen::Vector3d& x, double within) const override {
    return surfaceDistance(*part_, x, within);
  }

  TubeGap smallestGap(const std::vector<TubePiece>& tube, const Pose& pose,
                      const std::vector<CableStretch>& skipped) const override {
    Centreline line;
    line.pieces.reserve(tube.size());
    for (const TubePiece& piece : tube)
      line.pieces.push_back({piece.curve, piece.start, piece.end, piece.start_radius, piece.end_radius});
    std::vector<SkippedStretch> stretches;
    stretches.reserve(skipped.size());
    for (const CableStretch& stretch : skipped) stretches.push_back({stretch.start, stretch.end});
    // what is all but as near elsewhere, as all along a stretch that lies flat, is not asked for
    const std::optional<ClosestPair> closest = cable_variation::distance(line, *part_, pose, stretches, 0.0);
    if (!closest) return {std::numeric_limits<double>::infinity(), 0.0};
    return {closest->distance, line.arcLength(closest->place)};
  }

 private:
  std::shared_ptr<const DistancePart> part_;
};

}  // namespace

std::shared_ptr<const ContactSurface> makePartSurface(const TriangleMesh& mesh) {
  return makePartSurface(std::make_shared<const DistancePart>(mesh));
}

std::shared_ptr<const ContactSurface> makePartSurface(std::shared_ptr<const DistancePart> part) {
  return std::make_shared<PartSurface>(std::move(part));
}

}  // namespace cable_variation
