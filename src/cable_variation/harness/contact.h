#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/math/curve_piece.h>
#include <cable_variation/math/pose.h>
#include <cable_variation/math/surface_place.h>

namespace cable_variation {

/// A piece of a cable as a tube: a curve, with the radius linear along it.
struct TubePiece {
  CurvePiece curve;
  double start = 0.0, end = 0.0;                ///< arc lengths [m]
  double start_radius = 0.0, end_radius = 0.0;  ///< [m]
};

/// A stretch of a cable by its arc lengths [m].
struct CableStretch {
  double start = 0.0, end = 0.0;
};

/// Where a tube is closest to a part.
struct TubeGap {
  double gap = 0.0;         ///< between the surfaces, negative: they overlap [m]
  double arc_length = 0.0;  ///< [m]
};

/// The surface of a rigid part, all that contact knows of it. Immutable; may be shared by threads.
class ContactSurface {
 public:
  virtual ~ContactSurface() = default;

  /// Adds the places nearest to x, each among those about it, that are closer than `within` [m]; all in the
  /// part's frame.
  virtual void placesNear(const Eigen::Vector3d& x, double within,
                          std::vector<SurfacePlace>& places) const = 0;
  /// Of the nearest place, or `within` where none is closer [m].
  virtual double distance(const Eigen::Vector3d& x, double within) const = 0;
  /// The smallest gap between the tube and the part at `pose` (world), exact to 1e-7 m; negative: they
  /// overlap, by the depth where the part has an inside. Infinite when all of the tube is skipped.
  virtual TubeGap smallestGap(const std::vector<TubePiece>& tube, const Pose& pose,
                              const std::vector<CableStretch>& skipped) const = 0;
};

/// A cable that touches a part instead of entering it.
struct PartContact {
  std::size_t cable = 0;  ///< index into Harness::cables
  std::string part;       ///< its name
  std::shared_ptr<const ContactSurface> surface;
  Pose pose;                           ///< of the part, in the world
  double stand_off = 0.0;              ///< the gap that is kept [m]
  double skip_near_clips = 0.0;        ///< sections within this of one of `own_clips` do not count [m]
  std::vector<std::size_t> own_clips;  ///< that ride on the part, indices into Harness::clips
};

struct Harness;

/// Throws std::invalid_argument when the harness has contact: `what` ("envelopes") does not know it yet.
void requireNoContact(const Harness& harness, const std::string& what);

}  // namespace cable_variation
