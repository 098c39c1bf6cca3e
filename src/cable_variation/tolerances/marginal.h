#pragma once

#include <array>
#include <memory>
#include <vector>

#include <cable_variation/tolerances/distribution.h>

namespace cable_variation {

/// Draws from one design variable's distribution, fast: quantiles that take a search are tabulated as
/// polynomials of the normal score, within 1e-9 standard deviations of the true ones wherever checked; where
/// they are not, and beyond five normal standard deviations, the true one is taken.
class Marginal {
 public:
  /// Throws std::invalid_argument: makeDistribution().
  explicit Marginal(const DesignVariable& variable);

  const Distribution& distribution() const { return *distribution_; }
  double ofUniform(double probability) const;  ///< the deviation below which that share lies
  double ofScore(double score) const;          ///< the same, for the share normalShare(score)

 private:
  static constexpr std::size_t kTerms = 10;
  struct Piece {
    bool good = false;
    std::array<double, kTerms> chebyshev = {};
  };

  Piece pieceAt(std::size_t index) const;

  std::unique_ptr<const Distribution> distribution_;
  bool normal_ = false;
  double mean_ = 0.0, sigma_ = 0.0;
  std::vector<Piece> pieces_;  // empty: no table
};

}  // namespace cable_variation
