#pragma once  // internal to envelope/

#include <vector>

#include <Eigen/Core>

#include <cable_variation/tracking/stretch_shape.h>

namespace cable_variation {

/// How the rates of the stretches' ends change with the coordinates, as far as the rates of the shapes solved
/// so far tell: their least-squares fit, one matrix for each end and direction of space.
class CurvatureModel {
 public:
  /// Fits shapes. @param coordinates of each, relative to the first @param used which of them count
  /// @param widths of the coordinates, that the fit is scaled by
  void fit(const std::vector<StretchShape>& shapes, const std::vector<Eigen::VectorXd>& coordinates,
           const std::vector<bool>& used, const Eigen::VectorXd& widths);

  bool empty() const { return bends_.empty(); }
  /// Second derivatives of the height of an end along `outward` by the coordinates, symmetric.
  void along(std::size_t frame, std::size_t end, const Eigen::Vector4f& outward, Eigen::MatrixXf& bend) const;

 private:
  Eigen::Index coordinates_ = 0;
  std::vector<Eigen::Matrix4Xf> bends_;  // per frame: x y z and radius; columns end by end, matrix by matrix
};

}  // namespace cable_variation
