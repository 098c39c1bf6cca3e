#pragma once  // internal to geometry/

#include <array>

#include <Eigen/Core>

namespace cable_variation {

/// Signed solid angle of a triangle seen from x, in turns of the whole sphere: positive where its corners run
/// counter-clockwise seen from the other side, so that a closed surface seen from within, facing outwards,
/// has 1. (A. Van Oosterom, J. Strackee, The solid angle of a plane triangle, 1983.) The sum over any
/// triangles is their generalised winding number about x (A. Jacobson, L. Kavan, O. Sorkine-Hornung, Robust
/// inside-outside segmentation using generalized winding numbers, 2013).
double windingNumber(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& x);

}  // namespace cable_variation
