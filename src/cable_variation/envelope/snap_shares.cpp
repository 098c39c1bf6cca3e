#include <cable_variation/envelope/snap_shares.h>

#include <cable_variation/envelope/envelope_assembly.h>
#include <cable_variation/statistics/confidence.h>

namespace cable_variation {
namespace {

constexpr std::size_t kMostAside = 1000;

}  // namespace

void SnapShares::count(const RandomShape& shape) {
  if (!shape.converged) return;
  ++counted_;
  if (shape.jump.size() > 0 && !countJump(shape) && aside_.size() < kMostAside) aside_.push_back(shape);
}

void SnapShares::count(std::size_t drawn, const std::vector<RandomShape>& snapped) {
  counted_ += drawn;
  for (const RandomShape& shape : snapped) countJump(shape);
}

void SnapShares::tell(std::vector<Snap>& snaps, double confidence) {
  for (const RandomShape& shape : aside_) countJump(shape);
  aside_.clear();
  for (Snap& snap : snaps) {
    const std::size_t snapped = snapped_[snap.branch];
    if (counted_ > 0) snap.share = static_cast<double>(snapped) / static_cast<double>(counted_);
    snap.share_bound = shareUpperBound(snapped, counted_, confidence);
  }
}

// Whether its branch is known.
bool SnapShares::countJump(const RandomShape& shape) {
  const std::vector<std::size_t> numbers = branchNumbers(*searches_)[shape.phase];
  const std::size_t branch = (*searches_)[shape.phase].branchAfter(shape.jump);
  if (branch >= numbers.size()) return false;
  ++snapped_[numbers[branch]];
  return true;
}

}  // namespace cable_variation
