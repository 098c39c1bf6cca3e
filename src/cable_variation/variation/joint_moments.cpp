#include <cable_variation/variation/joint_moments.h>

namespace cable_variation {

namespace {

constexpr double kBinomial[5][5] = {
    {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};

std::array<double, 5> powersOf(double x) { return {1.0, x, x * x, x * x * x, x * x * x * x}; }

}  // namespace

void JointMoments::add(double x, double y) {
  const double n = static_cast<double>(count_ + 1);
  moveTo(mean_x_ + (x - mean_x_) / n, mean_y_ + (y - mean_y_) / n);
  const auto dx = powersOf(x - mean_x_), dy = powersOf(y - mean_y_);
  for (std::size_t i = 0; i <= kOrder; ++i) {
    for (std::size_t j = 0; i + j <= kOrder; ++j) sums_[i][j] += dx[i] * dy[j];
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

// Sums about another point by the binomial theorem, the highest orders first: they need the lower ones.
void JointMoments::moveTo(double mean_x, double mean_y) {
  const auto dx = powersOf(mean_x_ - mean_x), dy = powersOf(mean_y_ - mean_y);
  mean_x_ = mean_x;
  mean_y_ = mean_y;
  if (count_ == 0) return;
  for (std::size_t i = kOrder + 1; i-- > 0;) {
    for (std::size_t j = kOrder - i + 1; j-- > 0;) {
      double sum = 0.0;
      for (std::size_t a = 0; a <= i; ++a) {
        for (std::size_t b = 0; b <= j; ++b) {
          sum += kBinomial[i][a] * kBinomial[j][b] * dx[i - a] * dy[j - b] * sums_[a][b];
        }
      }
      sums_[i][j] = sum;
    }
  }
}

}  // namespace cable_variation
