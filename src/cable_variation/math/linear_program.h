#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace cable_variation {

/// Half-spaces a·x <= b of D unknowns: a and below it b, a column each.
template <int D>
using HalfSpaces = Eigen::Matrix<double, D + 1, Eigen::Dynamic>;

/// The point of half-spaces and the box |x_i| <= `box` at which c·x is smallest. For a few unknowns of size
/// about 1 and rows of length about 1: R. Seidel, Small-dimensional linear programming and convex hulls made
/// easy, 1991: the half-spaces are taken one after another, in an order mixed up but always the same; one
/// that the point violates holds with equality, and an unknown less is left. Half-spaces that leave nothing,
/// by rounding or truly, are violated by as little as possible: the caller sees it at the point.
template <int D>
Eigen::Matrix<double, D, 1> linearProgram(const Eigen::Matrix<double, D, 1>& c, const HalfSpaces<D>& rows,
                                          double box) {
  constexpr double kViolated = 1e-13, kNoRow = 1e-13;
  const auto bounded = [&](double slope) { return slope > 0.0 ? -box : box; };
  if constexpr (D == 1) {
    double low = -box, high = box;
    for (Eigen::Index i = 0; i < rows.cols(); ++i) {
      const double a = rows(0, i), limit = rows(1, i) / a;
      if (std::abs(a) < kNoRow) continue;
      (a > 0.0 ? high : low) = a > 0.0 ? std::min(high, limit) : std::max(low, limit);
    }
    const double x = low > high ? 0.5 * (low + high) : c[0] > 0.0 ? low : high;
    return Eigen::Matrix<double, 1, 1>(x);
  } else {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(rows.cols()));
    std::uint64_t mixed = 88172645463325252u;  // xorshift, G. Marsaglia 2003
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = static_cast<Eigen::Index>(i);
      mixed ^= mixed << 13;
      mixed ^= mixed >> 7;
      mixed ^= mixed << 17;
      std::swap(order[i], order[mixed % (i + 1)]);
    }
    Eigen::Matrix<double, D, 1> x = c.unaryExpr(bounded);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto row = rows.col(order[i]);
      Eigen::Index out;
      const double largest = row.template head<D>().cwiseAbs().maxCoeff(&out);
      if (largest < kNoRow || row.template head<D>().dot(x) <= row[D] + kViolated) continue;
      // x_out = row[D] / row[out] - sum of share_k x_k over the other unknowns
      const auto without = [&](const auto& column) {
        Eigen::Matrix<double, D - 1, 1> rest;
        for (Eigen::Index k = 0; k < D - 1; ++k) rest[k] = column[k < out ? k : k + 1];
        return rest;
      };
      const Eigen::Matrix<double, D - 1, 1> share = without(row) / row[out];
      const double level = row[D] / row[out];
      HalfSpaces<D - 1> left(D, static_cast<Eigen::Index>(i) + 2);
      for (std::size_t k = 0; k < i; ++k) {
        const auto other = rows.col(order[k]);
        auto to = left.col(static_cast<Eigen::Index>(k));
        to.template head<D - 1>() = without(other) - other[out] * share;
        to[D - 1] = other[D] - other[out] * level;
      }
      auto low = left.col(static_cast<Eigen::Index>(i)), high = left.col(static_cast<Eigen::Index>(i) + 1);
      low.template head<D - 1>() = -share;
      low[D - 1] = box - level;
      high.template head<D - 1>() = share;
      high[D - 1] = box + level;
      const Eigen::Matrix<double, D - 1, 1> rest =
          linearProgram<D - 1>(without(c) - c[out] * share, left, box);
      for (Eigen::Index k = 0; k < D - 1; ++k) x[k < out ? k : k + 1] = rest[k];
      x[out] = level - share.dot(rest);
    }
    return x;
  }
}

}  // namespace cable_variation
