#pragma once  // internal to envelope/

#include <vector>

#include <cable_variation/envelope/envelope_verification.h>

namespace cable_variation {

/// How far random shapes stick out of the pieces, of the usual ones and of the rare: those that snapped or
/// are on the way of a snap. Usual ones are thousands, and stick out by little. Rare ones are few and far
/// apart, so they stick out further, but only where the pieces of their own are: these alone are rounded for
/// them, and along the cable as far as they stick out there.
class RareRounding {
 public:
  explicit RareRounding(std::size_t stretches) : rare_(stretches, 0.0) {}

  void add(const std::vector<RandomShape>& shapes);
  double usual() const { return usual_; }  ///< that usual shapes stick out by at most [m]
  /// What pieces of rare shapes are to be rounded by, per stretch, beyond an inflation of all pieces [m]:
  /// twice what a rare shape sticks out by there or at a stretch near.
  std::vector<double> beyond(double inflation) const;

 private:
  double usual_ = 0.0;
  std::vector<double> rare_;  // per stretch, out of their own pieces
};

}  // namespace cable_variation
