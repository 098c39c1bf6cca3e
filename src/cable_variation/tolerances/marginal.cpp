#include <cable_variation/tolerances/marginal.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/math/normal.h>

namespace cable_variation {

namespace {

constexpr double kReach = 5.0;  // normal scores tabulated
constexpr std::size_t kPieces = 40;
constexpr double kWidth = 2.0 * kReach / kPieces;
constexpr double kError = 1e-9;  // standard deviations

double valueOf(const std::array<double, 10>& chebyshev, double x) {
  double next = 0.0, after = 0.0;  // Clenshaw's recurrence
  for (std::size_t k = chebyshev.size() - 1; k > 0; --k) {
    const double here = chebyshev[k] + 2.0 * x * next - after;
    after = next;
    next = here;
  }
  return chebyshev[0] + x * next - after;
}

}  // namespace

Marginal::Marginal(const DesignVariable& variable)
    : distribution_(makeDistribution(variable)),
      normal_(variable.distribution == "normal"),
      mean_(distribution_->mean()),
      sigma_(distribution_->standardDeviation()) {
  const bool searched = variable.distribution == "skew_normal" || variable.distribution == "beta";
  if (!searched) return;
  pieces_.reserve(kPieces);
  for (std::size_t i = 0; i < kPieces; ++i) pieces_.push_back(pieceAt(i));
}

Marginal::Piece Marginal::pieceAt(std::size_t index) const {
  const double middle = -kReach + kWidth * (static_cast<double>(index) + 0.5);
  const auto exact = [&](double x) {
    return distribution_->quantile(normalShare(middle + 0.5 * kWidth * x));
  };
  Piece piece;
  std::array<double, kTerms> values;
  for (std::size_t j = 0; j < kTerms; ++j) {
    values[j] = exact(std::cos(M_PI * (static_cast<double>(j) + 0.5) / kTerms));
  }
  for (std::size_t k = 0; k < kTerms; ++k) {
    double sum = 0.0;
    for (std::size_t j = 0; j < kTerms; ++j) {
      sum += values[j] * std::cos(M_PI * static_cast<double>(k) * (static_cast<double>(j) + 0.5) / kTerms);
    }
    piece.chebyshev[k] = (k == 0 ? 1.0 : 2.0) / kTerms * sum;
  }
  // between the nodes, where the error of a smooth quantile is largest, and at the ends
  piece.good = true;
  for (std::size_t j = 0; j <= kTerms; ++j) {
    const double x = std::cos(M_PI * static_cast<double>(j) / kTerms);
    if (!(std::abs(valueOf(piece.chebyshev, x) - exact(x)) < kError * sigma_)) piece.good = false;
  }
  return piece;
}

double Marginal::ofUniform(double probability) const {
  if (normal_ || !pieces_.empty()) return ofScore(normalScore(probability));
  return distribution_->quantile(probability);
}

double Marginal::ofScore(double score) const {
  if (normal_) return mean_ + sigma_ * score;
  if (!pieces_.empty() && std::abs(score) < kReach) {
    const double place = (score + kReach) / kWidth;
    const auto index = std::min(static_cast<std::size_t>(place), kPieces - 1);
    const Piece& piece = pieces_[index];
    if (piece.good) return valueOf(piece.chebyshev, 2.0 * (place - static_cast<double>(index)) - 1.0);
  }
  // the share of a score beyond 8.2 rounds to 1, beyond -38 to 0
  return distribution_->quantile(std::clamp(normalShare(score), 0x1p-1000, 1.0 - 0x1p-53));
}

}  // namespace cable_variation
