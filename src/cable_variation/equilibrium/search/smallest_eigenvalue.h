#pragma once  // internal to equilibrium/

#include <string>
#include <vector>

#include <cable_variation/equilibrium/discretisation/neutral_motions.h>
#include <cable_variation/equilibrium/discretisation/rod_system.h>

namespace cable_variation {

/// The softest motion of a harness, those left out that cost nothing.
struct SoftestMotion {
  double eigenvalue = 0.0;             ///< [N/m]
  NodalField motion;                   ///< of norm 1 in the metric of the surface's mean square motion
  std::vector<NeutralMotion> neutral;  ///< exactly so, and known as such from the model
  std::vector<NodalField> unnamed;     ///< others, which cost no more than rounding; of norm 1
};

/// The smallest eigenvalue of the Hessian in the metric of the surface's mean square motion, over all motions
/// but the neutral ones; after evaluate() with the exact Hessian at the equilibrium `configuration`. By
/// Lanczos' method on the inverse, to 1e-9 of itself; the motion is right to about the square root of that.
/// @param near the softest motion of a similar harness on the same grid: it is found faster from there
SoftestMotion softestMotion(RodSystem& system, const Configuration& configuration,
                            const NodalField* near = nullptr);

/// The same of a shape near by on another grid of the same harness, where `of` was found: motions that are
/// neutral there are left out here.
double smallestEigenvalueBeside(const SoftestMotion& of, RodSystem& system,
                                const Configuration& configuration);

/// The motion of the smallest eigenvalue of all: at a shape that is not stable the way down.
NodalField motionOfLeastStiffness(RodSystem& system, const Configuration& configuration);

/// The eigenvalue of softestMotion() [N/m], and its motion.
double smallestEigenvalue(RodSystem& system, const Configuration& configuration, NodalField* motion = nullptr,
                          const NodalField* near = nullptr);
/// The same among motions that open no gap which presses (HeldContacts): whatever the gaps' stiffness is.
double smallestEigenvalueInContact(RodSystem& system, const Configuration& configuration);

/// What neutral motions there are, and that the smallest eigenvalue is that of the others; empty: none.
std::string neutralText(const SoftestMotion& softest, const RodSystem& system,
                        const Configuration& configuration);

}  // namespace cable_variation
