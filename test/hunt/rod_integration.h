#pragma once

#include <Eigen/Geometry>

#include <cable_variation/rod/profile.h>

namespace cable_variation::hunt {

/// All that the rod's equations carry along s: pose of the section, section force [N] and moment [N m] in the
/// world, of the part s+ on the part s-.
struct RodState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

/// The Cosserat rod from arc length `start` to `end` > `start` [m], between which its properties are smooth:
/// φ' = R(e₁ + K_Γ⁻¹Rᵀf), R' = R[Ω₀ + K_Ω⁻¹Rᵀm]×, f' = -ρA g, m' = -φ' × f, by the embedded Runge-Kutta pair
/// of Dormand and Prince (1980) with local errors of `tolerance`, relative to the step's own scales.
/// `steps`, if given, is the number of steps taken.
RodState integrateRod(const RodProfile& profile, const Eigen::Vector3d& gravity, const RodState& from,
                      double start, double end, double tolerance = 1e-11, int* steps = nullptr);

}  // namespace cable_variation::hunt
