#include <cable_variation/sensitivity/coupling.h>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

// Suh's three kinds, with the matrices that define them.
TEST(Coupling, DiagonalIsUncoupled) {
  EXPECT_EQ(couplingOf(Eigen::Matrix3d(Eigen::Vector3d(2.0, -1.0, 0.5).asDiagonal())), Coupling::uncoupled);
}

TEST(Coupling, TriangularIsDecoupledInWhateverOrder) {
  Eigen::Matrix3d effects;
  effects << 1, 0, 0, 1, 1, 0, 1, 1, 1;
  EXPECT_EQ(couplingOf(effects), Coupling::decoupled);
  Eigen::Matrix3d mixed;
  mixed << effects.row(2), effects.row(0), effects.row(1);
  mixed.col(0).swap(mixed.col(2));
  EXPECT_EQ(couplingOf(mixed), Coupling::decoupled);
}

TEST(Coupling, FullIsCoupled) {
  Eigen::Matrix2d effects;
  effects << 1, 1, 1, -1;
  EXPECT_EQ(couplingOf(effects), Coupling::coupled);
}

TEST(Coupling, EffectsBelowATenthOfTheRowsLargestAreNone) {
  Eigen::Matrix2d effects;
  effects << 1.0, 0.09, -0.0009, 0.01;
  EXPECT_EQ(couplingOf(effects), Coupling::uncoupled);
  effects(1, 0) = 0.0011;
  EXPECT_EQ(couplingOf(effects), Coupling::decoupled);
}

TEST(Coupling, MoreVariablesThanMeasures) {
  Eigen::Matrix<double, 2, 4> effects;
  effects << 1, 1, 1, 0, 1, 0, 1, 1;
  EXPECT_EQ(couplingOf(effects), Coupling::decoupled);  // the second and the fourth variable have one each
}

}  // namespace
}  // namespace cable_variation
