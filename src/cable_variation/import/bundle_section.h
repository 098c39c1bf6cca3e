#pragma once

#include <vector>

#include <cable_variation/rod/section.h>

namespace cable_variation {

/// How stiffness and mass of a bundle follow from its wires. Wires that slip on each other bend each about
/// its own axis, wires that stick bend as one; a real bundle lies in between, near the first.
struct BundleRule {
  double conductor_modulus = 1.1e11;  ///< E of the conductors when they are drawn, copper [Pa]
  double bending_modulus = 1e10;      ///< the same when one is bent: its strands slip [Pa]
  double sticking = 0.01;             ///< from slipping wires (0) to sticking ones (1), for EI
  double poisson_ratio = 0.3;         ///< for GJ = EI/(1 + ν), GA = EA/(2 (1 + ν))
  double density = 2500.0;            ///< of the cross-section, where a mass is not known [kg/m³]
  double conductor_share = 0.25;      ///< of the cross-section, where wires are not known
  double wire_area = 0.5e-6;          ///< of such a wire's conductor [m²]
};

/// One of a bundle's wires.
struct BundleWire {
  double conductor_area = 0.0;   ///< [m²]
  double mass_per_length = 0.0;  ///< [kg/m]
};

/// The section of a bundle of `radius` [m]:
///   EA = E Σ Aᵢ,  EI = (1 - β) E_b Σ Aᵢ²/(4π) + β E R²/4 Σ Aᵢ
/// with the sticking β and the conductors evenly over the circle. Without wires as many are taken as fill the
/// rule's share. @param protection mass of tape and tubes [kg/m]
Section bundleSection(double radius, const std::vector<BundleWire>& wires, double protection,
                      const BundleRule& rule);

}  // namespace cable_variation
