#pragma once

namespace cable_variation {

/// An isotropic elastic material.
struct Material {
  double young_modulus = 0.0;  ///< E [Pa]
  double poisson_ratio = 0.0;  ///< ν, in (-1, 0.5]
  double density = 0.0;        ///< ρ [kg/m³]

  double shearModulus() const { return young_modulus / (2.0 * (1.0 + poisson_ratio)); }  ///< G [Pa]
};

/// What a cross-section is to the rod: its stiffness, weight and visible size.
/// The x axis is the tangent; y and z span the section.
struct Section {
  double EA = 0.0;               ///< stretch stiffness [N]
  double GA_y = 0.0;             ///< shear stiffness along y [N]
  double GA_z = 0.0;             ///< shear stiffness along z [N]
  double GJ = 0.0;               ///< torsion stiffness [N m²]
  double EI_y = 0.0;             ///< bending stiffness about y [N m²]
  double EI_z = 0.0;             ///< bending stiffness about z [N m²]
  double mass_per_length = 0.0;  ///< ρA [kg/m]
  double radius = 0.0;           ///< of the smallest circle about the centre that holds the section [m]
  double young_modulus = 0.0;    ///< E [Pa], for stresses; 0: unknown, the stiffness was given as such
  double shear_modulus = 0.0;    ///< G [Pa], likewise
  double width = 0.0;            ///< of a rectangle, along y [m]; 0: round, or not known
  double height = 0.0;           ///< of a rectangle, along z [m]
};

/// Solid circle of `radius` [m]. Shear correction κ as given (1: none).
Section solidSection(double radius, const Material& material, double shear_correction = 1.0);

/// Annulus between `inner_radius` and `outer_radius` [m].
Section hoseSection(double outer_radius, double inner_radius, const Material& material,
                    double shear_correction = 1.0);

/// Rectangle of `width` along y and `height` along z [m], torsion constant by
/// the series of Saint-Venant (Timoshenko and Goodier, Theory of Elasticity, §109).
Section rectangleSection(double width, double height, const Material& material,
                         double shear_correction = 1.0);

/// Linear blend, (1 - t) a + t b.
Section interpolate(const Section& a, const Section& b, double t);

/// Throws std::invalid_argument naming the member and its value unless every
/// stiffness is positive and finite, and mass and radius are not negative.
void validate(const Section& section);

}  // namespace cable_variation
