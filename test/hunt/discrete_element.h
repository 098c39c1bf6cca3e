#pragma once

#include <Eigen/Geometry>

#include <cable_variation/rod/profile.h>

namespace cable_variation::hunt {

/// Energy of one element ½ h εᵀKε with ε = v/h - ε₀, where v depends on the unknowns of the sections, h on
/// the arc lengths of the piece's ends (as do K and ε₀, taken at the element's middle).
struct StrainEnergy {
  StrainEnergy(const Eigen::Vector3d& v, double length, const Eigen::Vector3d& stiffness,
               const Eigen::Vector3d& stiffness_slope, const Eigen::Vector3d& rest,
               const Eigen::Vector3d& rest_slope);

  Eigen::Vector3d strain, stress;  ///< ε, and Kε: derivative of the energy by v
  double energy;
  double by_length, by_place;                                ///< derivatives by h and by the middle's place
  Eigen::Vector3d by_v_length, by_v_place;                   ///< mixed second derivatives
  double by_length_length, by_length_place, by_place_place;  ///< second derivatives
};

/// v of stretch and shear: Rᵀ(φ₂ - φ₁). Derivatives by displacements φ₁, φ₂ and the segment's rotation vector
/// in its own frame: rows of `first`; `second` is the Hessian of n·v for a given n.
struct StretchVector {
  using First = Eigen::Matrix<double, 3, 9>;
  using Second = Eigen::Matrix<double, 9, 9>;
  StretchVector(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Quaterniond& segment);
  Eigen::Vector3d value;
  First first() const;
  Second second(const Eigen::Vector3d& n) const;

 private:
  Eigen::Matrix3d transposed_;
};

/// v of bending and torsion: twice the vector part of the quaternion q̄_a q_b, as it depends on the rotation
/// vectors of both frames in their own frames.
struct CurvatureVector {
  using First = Eigen::Matrix<double, 3, 6>;
  using Second = Eigen::Matrix<double, 6, 6>;
  CurvatureVector(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);
  Eigen::Vector3d value;
  First first() const;
  Second second(const Eigen::Vector3d& m) const;

 private:
  double w_;
  Eigen::Vector3d p_;
};

}  // namespace cable_variation::hunt
