#pragma once  // internal to equilibrium/

#include <cable_variation/equilibrium/discretisation/rod_system.h>

namespace cable_variation {

/// The smallest eigenvalue of the Hessian in the metric of the surface's mean
/// square motion [N/m], and its motion; after evaluate() with the exact Hessian at
/// `configuration`. By Lanczos' method on the inverse, to 1e-9 of itself; the
/// motion is right to about the square root of that.
/// @param near the softest motion of a similar harness on the same grid: it is found faster from there
double smallestEigenvalue(RodSystem& system, const Configuration& configuration, NodalField* motion = nullptr,
                          const NodalField* near = nullptr);
/// The same among motions that open no gap which presses (HeldContacts): whatever the gaps' stiffness is.
double smallestEigenvalueInContact(RodSystem& system, const Configuration& configuration);

}  // namespace cable_variation
