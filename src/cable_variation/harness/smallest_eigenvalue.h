#pragma once

#include <cable_variation/harness/rod_system.h>

namespace cable_variation {

/// The smallest eigenvalue of the Hessian in the metric of the surface's mean
/// square motion [N/m], and its motion; after evaluate() with the exact Hessian at
/// `configuration`. By Lanczos' method on the inverse, to
/// `accuracy` relative to itself; the motion is then right to about the accuracy's square root.
double smallestEigenvalue(RodSystem& system, const Configuration& configuration, NodalField* motion = nullptr,
                          double accuracy = 1e-9);

}  // namespace cable_variation
