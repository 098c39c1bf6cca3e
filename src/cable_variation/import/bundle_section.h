#pragma once

#include <optional>
#include <vector>

#include <cable_variation/rod/section.h>

namespace cable_variation {

/// How stiffness and mass of a bundle follow from its wires, where they are not known of a wire itself.
struct BundleRule {
  double conductor_modulus = 1.1e11;  ///< E of the conductors when they are drawn, copper [Pa]
  double bending_modulus = 1e10;      ///< the same when one is bent: its strands slip [Pa]
  double sticking = 0.01;             ///< from slipping wires (0) to sticking ones (1), for EI and GJ
  double poisson_ratio = 0.3;         ///< for GJ = EI/(1 + ν), GA = EA/(2 (1 + ν))
  double density = 2500.0;            ///< of the cross-section, where a mass is not known [kg/m³]
  double conductor_share = 0.25;      ///< of the cross-section, where wires are not known
  double wire_area = 0.5e-6;          ///< of such a wire's conductor [m²]
};

/// One of a bundle's wires.
struct BundleWire {
  double conductor_area = 0.0;    ///< [m²]
  double mass_per_length = 0.0;   ///< [kg/m]
  double diameter = 0.0;          ///< insulation included [m]; 0: by the rule's share of conductors
  std::optional<double> modulus;  ///< of its conductor when it is drawn, else the rule's [Pa]
  std::optional<double> EI;       ///< as measured of one wire, else E_b A²/(4π) [N m²]
  std::optional<double> GJ;       ///< likewise, else EI/(1 + ν) [N m²]
};

/// What tape and tubes add, evenly along the bundle. They slip on it: their stiffness is their own.
struct BundleCover {
  double mass_per_length = 0.0;         ///< [kg/m]
  double EA = 0.0, EI = 0.0, GJ = 0.0;  ///< [N], [N m²], [N m²]
};

/// A bundle's section between its two bounds, which differ in EI and GJ alone.
struct BundleBounds {
  Section slipping;  ///< wires, and their strands, slip on each other: each bends about its own axis
  Section sticking;  ///< all stick: sections stay plane
};

/// Of a bundle of `radius` R [m]:
///   EA = Σ Eᵢ Aᵢ,  slipping EI = Σ EIᵢ,
///   sticking EI = Σ Eᵢ (Aᵢ²/(4π) + Aᵢ (R²/4 - dᵢ²/16)), the parallel axis theorem with the mean square
///   distance
/// from the axis of bending that wires of the diameter d have when they are spread evenly over the circle,
/// GJ likewise. Each plus the cover's. Without wires as many are taken as fill the rule's share of
/// conductors.
BundleBounds bundleBounds(double radius, const std::vector<BundleWire>& wires, const BundleCover& cover,
                          const BundleRule& rule);

/// The section in between: EI and GJ at the share `sticking` of the way, 0 to 1.
Section sectionBetween(const BundleBounds& bounds, double sticking);

}  // namespace cable_variation
