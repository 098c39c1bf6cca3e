#include <cable_variation/envelope/search/curvature_model.h>

#include <algorithm>

#include <Eigen/Cholesky>

#include <tbb/parallel_for.h>

namespace cable_variation {
namespace {

constexpr std::size_t kMostShapes = 400;  // more add time and no knowledge
constexpr double kRidge = 1e-3;           // of a shape at a limit: keeps apart what shapes do not tell

}  // namespace

void CurvatureModel::fit(const std::vector<StretchShape>& shapes,
                         const std::vector<Eigen::VectorXd>& coordinates, const std::vector<bool>& used,
                         const Eigen::VectorXd& widths) {
  coordinates_ = widths.size();
  std::vector<std::size_t> chosen;
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    if (used[i]) chosen.push_back(i);
  }
  // the first ones reach furthest, the last ones are where it matters
  if (chosen.size() > kMostShapes) {
    chosen.erase(chosen.begin() + kMostShapes / 2, chosen.end() - kMostShapes / 2);
  }
  const auto count = static_cast<Eigen::Index>(chosen.size());
  const auto shapeOf = [&](Eigen::Index row) { return chosen[static_cast<std::size_t>(row)]; };
  Eigen::MatrixXd change(count, coordinates_);
  for (Eigen::Index row = 0; row < count; ++row) {
    change.row(row) = (coordinates[shapeOf(row)] - coordinates[0]).cwiseQuotient(widths).transpose();
  }
  Eigen::MatrixXd normal = change.transpose() * change;
  normal.diagonal().array() += kRidge;
  const Eigen::MatrixXf solution =
      (widths.cwiseInverse().asDiagonal() * normal.llt().solve(change.transpose())).cast<float>();

  bends_.resize(shapes.front().rates.size());
  for (std::size_t frame = 0; frame < bends_.size(); ++frame) {
    const Eigen::Matrix4Xf& reference = shapes.front().rates[frame];
    bends_[frame].setZero(4, reference.cols() * coordinates_);
    const Eigen::Index ends = reference.cols() / coordinates_;
    tbb::parallel_for(Eigen::Index{0}, ends, [&](Eigen::Index end) {
      Eigen::MatrixXf rates(count, 4 * coordinates_);
      for (Eigen::Index row = 0; row < count; ++row) {
        const Eigen::Matrix4Xf difference =
            shapes[shapeOf(row)].rates[frame].middleCols(end * coordinates_, coordinates_) -
            reference.middleCols(end * coordinates_, coordinates_);
        rates.row(row) = Eigen::Map<const Eigen::RowVectorXf>(difference.data(), difference.size());
      }
      const Eigen::MatrixXf bend = solution * rates;  // by (coordinate, 4 coordinate)
      for (Eigen::Index i = 0; i < coordinates_; ++i) {
        for (Eigen::Index j = 0; j < coordinates_; ++j) {
          for (Eigen::Index c = 0; c < 4; ++c) {
            bends_[frame](c, (end * coordinates_ + i) * coordinates_ + j) =
                0.5F * (bend(i, 4 * j + c) + bend(j, 4 * i + c));
          }
        }
      }
    });
  }
}

void CurvatureModel::along(std::size_t frame, std::size_t end, const Eigen::Vector4f& outward,
                           Eigen::MatrixXf& bend) const {
  bend.resize(coordinates_, coordinates_);
  const Eigen::Index size = coordinates_ * coordinates_;
  Eigen::Map<Eigen::RowVectorXf>(bend.data(), size).noalias() =
      outward.transpose() * bends_[frame].middleCols(static_cast<Eigen::Index>(end) * size, size);
}

}  // namespace cable_variation
