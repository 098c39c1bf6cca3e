#include <cable_variation/simulation/variance_contribution.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace cable_variation {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<double> VarianceContributor::binEdges(const Distribution& distribution) {
  std::vector<double> edges;
  edges.reserve(kBins - 1);
  for (std::size_t i = 1; i < kBins; ++i)
    edges.push_back(distribution.quantile(static_cast<double>(i) / kBins));
  return edges;
}

VarianceContributor::VarianceContributor(std::vector<std::vector<double>> edges, std::size_t measures)
    : edges_(std::move(edges)), measures_(measures), bins_(edges_.size() * kBins * measures) {
  const auto size = static_cast<Index>(edges_.size() + measures);
  mean_ = row_ = VectorXd::Zero(size);
  scatter_ = MatrixXd::Zero(size, size);
}

void VarianceContributor::Mean::add(const Mean& other) {
  if (other.count == 0) return;
  count += other.count;
  value += (other.value - value) * static_cast<double>(other.count) / static_cast<double>(count);
}

void VarianceContributor::add(const double* deviations, const double* values) {
  if (!std::all_of(values, values + measures_, [](double value) { return std::isfinite(value); })) {
    ++left_out_;
    return;
  }
  std::copy(deviations, deviations + variableCount(), row_.data());
  std::copy(values, values + measures_, row_.data() + variableCount());
  ++count_;
  const auto n = static_cast<double>(count_);
  row_ -= mean_;
  scatter_.selfadjointView<Eigen::Lower>().rankUpdate(row_, (n - 1.0) / n);
  mean_ += row_ / n;
  for (std::size_t j = 0; j < variableCount(); ++j) {
    const auto bin = static_cast<std::size_t>(
        std::lower_bound(edges_[j].begin(), edges_[j].end(), deviations[j]) - edges_[j].begin());
    Mean* means = bins_.data() + (j * kBins + bin) * measures_;
    for (std::size_t i = 0; i < measures_; ++i) means[i].add({1, values[i]});
  }
}

void VarianceContributor::merge(const VarianceContributor& later) {
  left_out_ += later.left_out_;
  if (later.count_ == 0) return;
  const double before = static_cast<double>(count_), added = static_cast<double>(later.count_);
  count_ += later.count_;
  const VectorXd step = later.mean_ - mean_;
  scatter_ += later.scatter_;
  scatter_.selfadjointView<Eigen::Lower>().rankUpdate(step, before * added / (before + added));
  mean_ += step * (added / (before + added));
  for (std::size_t i = 0; i < bins_.size(); ++i) bins_[i].add(later.bins_[i]);
}

VarianceContributions VarianceContributor::contributions() const {
  VarianceContributions result;
  result.count = count_;
  result.left_out = left_out_;
  if (measures_ == 0 || variableCount() == 0) return result;
  addRegression(result);
  addFirstOrder(result);
  return result;
}

void VarianceContributor::addRegression(VarianceContributions& result) const {
  if (count_ < variableCount() + 3) return;
  constexpr double kSingular = 1e-10;  // eigenvalue of the correlations below which they tell nothing
  const auto v = static_cast<Index>(variableCount()), m = static_cast<Index>(measures_);
  const VectorXd size = scatter_.diagonal().cwiseSqrt();
  const auto inverse = [](double x) { return x > 0.0 ? 1.0 / x : 0.0; };
  const VectorXd scale = size.unaryExpr(inverse);
  const MatrixXd whole = scatter_.selfadjointView<Eigen::Lower>();
  const MatrixXd correlation = scale.asDiagonal() * whole * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(correlation.topLeftCorner(v, v));
  const VectorXd pseudo =
      eigen.eigenvalues().unaryExpr([](double x) { return x > kSingular ? 1.0 / x : 0.0; });
  const MatrixXd with_measures = correlation.bottomLeftCorner(m, v);
  result.standardised =
      with_measures * eigen.eigenvectors() * pseudo.asDiagonal() * eigen.eigenvectors().transpose();
  result.regression_share = result.standardised.cwiseProduct(with_measures);
  result.r_squared = result.regression_share.rowwise().sum();
  result.slope = size.tail(m).asDiagonal() * result.standardised * scale.head(v).asDiagonal();
  for (Index i = 0; i < m; ++i) {
    if (size[v + i] > 0.0) continue;
    result.regression_share.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
    result.r_squared[i] = std::numeric_limits<double>::quiet_NaN();
  }
}

void VarianceContributor::addFirstOrder(VarianceContributions& result) const {
  constexpr std::uint64_t kPerBin = 16;  // samples, at least
  std::size_t bins = kBins;
  while (bins > 1 && count_ < bins * kPerBin) bins /= 2;
  if (bins < 2) return;
  result.bins = bins;
  result.first_order.resize(static_cast<Index>(measures_), static_cast<Index>(variableCount()));
  for (std::size_t i = 0; i < measures_; ++i) {
    for (std::size_t j = 0; j < variableCount(); ++j) {
      result.first_order(static_cast<Index>(i), static_cast<Index>(j)) = firstOrder(j, i, bins);
    }
  }
}

// The sum of squares between the bins, less what it would be by chance alone, over the whole one (ε² of the
// analysis of variance; Kelley 1935).
double VarianceContributor::firstOrder(std::size_t variable, std::size_t measure, std::size_t bins) const {
  const auto row = static_cast<Index>(variableCount() + measure);
  const double total = scatter_(row, row);
  if (!(total > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t group = kBins / bins;
  double between = 0.0;
  std::size_t filled = 0;  // a discrete variable leaves bins empty
  for (std::size_t bin = 0; bin < kBins; bin += group) {
    Mean mean;
    for (std::size_t k = bin; k < bin + group; ++k)
      mean.add(bins_[(variable * kBins + k) * measures_ + measure]);
    if (mean.count == 0) continue;
    ++filled;
    between += static_cast<double>(mean.count) * (mean.value - mean_[row]) * (mean.value - mean_[row]);
  }
  const double chance = (total - between) / static_cast<double>(count_ - filled);
  return (between - static_cast<double>(filled - 1) * chance) / total;
}

}  // namespace cable_variation
