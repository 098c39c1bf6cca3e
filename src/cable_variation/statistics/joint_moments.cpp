#include <cable_variation/statistics/joint_moments.h>

namespace cable_variation {

void JointMoments::add(double x, double y) {
  const double n = static_cast<double>(count_ + 1);
  moveTo(mean_x_ + (x - mean_x_) / n, mean_y_ + (y - mean_y_) / n);
  const double dx = x - mean_x_, dy = y - mean_y_;
  double power_x = 1.0;
  for (std::size_t i = 0; i <= kOrder; ++i, power_x *= dx) {
    double power = power_x;
    for (std::size_t j = 0; i + j <= kOrder; ++j, power *= dy) sums_[i][j] += power;
  }
  ++count_;
}

void JointMoments::merge(const JointMoments& other) {
  if (other.count_ == 0) return;
  if (count_ == 0) {
    *this = other;
    return;
  }
  const double share = static_cast<double>(other.count_) / static_cast<double>(count_ + other.count_);
  const double mean_x = mean_x_ + share * (other.mean_x_ - mean_x_);
  const double mean_y = mean_y_ + share * (other.mean_y_ - mean_y_);
  JointMoments moved = other;
  moved.moveTo(mean_x, mean_y);
  moveTo(mean_x, mean_y);
  for (std::size_t i = 0; i <= kOrder; ++i) {
    for (std::size_t j = 0; i + j <= kOrder; ++j) sums_[i][j] += moved.sums_[i][j];
  }
  count_ += other.count_;
}

double JointMoments::central(int i, int j) const {
  return sums_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] / static_cast<double>(count_);
}

// The binomial theorem for each variable, Σ (x + d)^i from Σ x^a, by Pascal's triangle in place: 40 additions
// instead of 70 terms.
void JointMoments::moveTo(double mean_x, double mean_y) {
  const double dx = mean_x_ - mean_x, dy = mean_y_ - mean_y;
  mean_x_ = mean_x;
  mean_y_ = mean_y;
  for (std::size_t j = 0; j < kOrder; ++j) {
    for (std::size_t pass = 1; pass + j <= kOrder; ++pass) {
      for (std::size_t i = kOrder - j; i >= pass; --i) sums_[i][j] += dx * sums_[i - 1][j];
    }
  }
  for (std::size_t i = 0; i < kOrder; ++i) {
    for (std::size_t pass = 1; pass + i <= kOrder; ++pass) {
      for (std::size_t j = kOrder - i; j >= pass; --j) sums_[i][j] += dy * sums_[i][j - 1];
    }
  }
}

}  // namespace cable_variation
