#include <cable_variation/tracking/snap_way.h>

#include <algorithm>
#include <cmath>

namespace cable_variation {
namespace {

// Shapes before this belong together; beyond, slices of this width overlap by so much. In shares of the jump.
constexpr double kRareFrom = 0.4, kWidth = 0.2, kOverlap = 0.03;
constexpr int kMostSlices = 8;

int sliceAt(double at) {
  if (!(at >= kRareFrom)) return 0;
  return std::min(kMostSlices, 1 + static_cast<int>((at - kRareFrom) / kWidth));
}

}  // namespace

SnapWay::SnapWay(const Eigen::Matrix3Xd& reference, const Eigen::Matrix3Xd& motion)
    : reference_(reference), motion_(motion) {}

SnapWay::Progress SnapWay::of(const StretchShape& shape, Eigen::Index coordinates) const {
  Progress progress;
  if (empty()) return progress;
  const double squared = motion_.squaredNorm();
  progress.at = (shape.ends[0] - reference_).cwiseProduct(motion_).sum() / squared;
  if (shape.rates.empty()) return progress;
  progress.rates.setZero(coordinates);
  for (Eigen::Index end = 0; end < motion_.cols(); ++end) {
    const auto rates = shape.endRates(0, static_cast<std::size_t>(end), coordinates).topRows<3>();
    progress.rates += (rates.cast<double>().transpose() * motion_.col(end)) / squared;
  }
  return progress;
}

SnapWay::Slices SnapWay::slices(double at) const {
  if (empty()) return {};
  return {sliceAt(at - kOverlap), sliceAt(at + kOverlap)};
}

}  // namespace cable_variation
