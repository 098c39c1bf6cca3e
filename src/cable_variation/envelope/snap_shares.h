#pragma once  // internal to envelope/

#include <map>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/envelope/envelope_verification.h>

namespace cable_variation {

/// Which share of random shapes snapped, by branch of the envelope. The searches must outlive it.
class SnapShares {
 public:
  explicit SnapShares(const std::vector<PhaseSearch>& searches) : searches_(&searches) {}

  /// One that was drawn as the share is meant. If it snapped to a branch that is not known yet it is put
  /// aside.
  void count(const RandomShape& shape);
  /// Of `drawn` shapes with an equilibrium these snapped.
  void count(std::size_t drawn, const std::vector<RandomShape>& snapped);
  /// Once the branches of those put aside are known: the shares beyond each, and their bounds.
  void tell(std::vector<Snap>& snaps, double confidence);

 private:
  bool countJump(const RandomShape& shape);

  const std::vector<PhaseSearch>* searches_;
  std::size_t counted_ = 0;
  std::map<std::size_t, std::size_t> snapped_;  // per branch of the envelope
  std::vector<RandomShape> aside_;
};

}  // namespace cable_variation
