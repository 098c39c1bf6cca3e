#include <cable_variation/rod/section.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace cable_variation {
namespace {

void requirePositive(const char* what, double value) {
  if (std::isfinite(value) && value > 0.0) return;
  std::ostringstream text;
  text << what << " is " << value << ", expected a positive number";
  throw std::invalid_argument(text.str());
}

void requireNotNegative(const char* what, double value) {
  if (std::isfinite(value) && value >= 0.0) return;
  std::ostringstream text;
  text << what << " is " << value << ", expected zero or more";
  throw std::invalid_argument(text.str());
}

void validate(const Material& material) {
  requirePositive("young_modulus", material.young_modulus);
  requireNotNegative("density", material.density);
  if (!(material.poisson_ratio > -1.0 && material.poisson_ratio <= 0.5)) {
    std::ostringstream text;
    text << "poisson_ratio is " << material.poisson_ratio << ", expected more than -1 and at most 0.5";
    throw std::invalid_argument(text.str());
  }
}

struct Geometry {
  double area, second_moment_y, second_moment_z, torsion_constant, radius;
};

Section sectionOf(const Geometry& geometry, const Material& material, double shear_correction) {
  validate(material);
  requirePositive("shear_correction", shear_correction);
  const double E = material.young_modulus;
  const double G = material.shearModulus();
  Section section;
  section.EA = E * geometry.area;
  section.GA_y = section.GA_z = shear_correction * G * geometry.area;
  section.GJ = G * geometry.torsion_constant;
  section.EI_y = E * geometry.second_moment_y;
  section.EI_z = E * geometry.second_moment_z;
  section.mass_per_length = material.density * geometry.area;
  section.radius = geometry.radius;
  section.young_modulus = E;
  section.shear_modulus = G;
  return section;
}

// Torsion constant of a rectangle, Timoshenko and Goodier §109: a b³ (1/3 - 64/π⁵ b/a Σ tanh(nπa/2b)/n⁵), a
// >= b.
double rectangleTorsionConstant(double width, double height) {
  const double a = std::fmax(width, height);
  const double b = std::fmin(width, height);
  double sum = 0.0;
  for (int n = 1; n < 40; n += 2) sum += std::tanh(n * M_PI * a / (2.0 * b)) / std::pow(n, 5);
  return a * b * b * b * (1.0 / 3.0 - 64.0 / std::pow(M_PI, 5) * b / a * sum);
}

}  // namespace

Section solidSection(double radius, const Material& material, double shear_correction) {
  requirePositive("radius", radius);
  const double r2 = radius * radius;
  const double I = 0.25 * M_PI * r2 * r2;
  return sectionOf({M_PI * r2, I, I, 2.0 * I, radius}, material, shear_correction);
}

Section hoseSection(double outer_radius, double inner_radius, const Material& material,
                    double shear_correction) {
  requirePositive("outer_radius", outer_radius);
  requireNotNegative("inner_radius", inner_radius);
  if (inner_radius >= outer_radius) {
    std::ostringstream text;
    text << "inner_radius is " << inner_radius << " m, expected less than the outer_radius of "
         << outer_radius << " m";
    throw std::invalid_argument(text.str());
  }
  const double o2 = outer_radius * outer_radius;
  const double i2 = inner_radius * inner_radius;
  const double I = 0.25 * M_PI * (o2 * o2 - i2 * i2);
  return sectionOf({M_PI * (o2 - i2), I, I, 2.0 * I, outer_radius}, material, shear_correction);
}

Section rectangleSection(double width, double height, const Material& material, double shear_correction) {
  requirePositive("width", width);
  requirePositive("height", height);
  Section section =
      sectionOf({width * height, width * std::pow(height, 3) / 12.0, height * std::pow(width, 3) / 12.0,
                 rectangleTorsionConstant(width, height), 0.5 * std::hypot(width, height)},
                material, shear_correction);
  section.width = width;
  section.height = height;
  return section;
}

Section interpolate(const Section& a, const Section& b, double t) {
  const auto blend = [t](double x, double y) { return (1.0 - t) * x + t * y; };
  const auto blendKnown = [&](double x, double y) { return x > 0.0 && y > 0.0 ? blend(x, y) : 0.0; };
  return {blend(a.EA, b.EA),
          blend(a.GA_y, b.GA_y),
          blend(a.GA_z, b.GA_z),
          blend(a.GJ, b.GJ),
          blend(a.EI_y, b.EI_y),
          blend(a.EI_z, b.EI_z),
          blend(a.mass_per_length, b.mass_per_length),
          blend(a.radius, b.radius),
          blendKnown(a.young_modulus, b.young_modulus),
          blendKnown(a.shear_modulus, b.shear_modulus),
          blendKnown(a.width, b.width),
          blendKnown(a.height, b.height)};
}

void validate(const Section& section) {
  requirePositive("EA", section.EA);
  requirePositive("GA_y", section.GA_y);
  requirePositive("GA_z", section.GA_z);
  requirePositive("GJ", section.GJ);
  requirePositive("EI_y", section.EI_y);
  requirePositive("EI_z", section.EI_z);
  requireNotNegative("mass_per_length", section.mass_per_length);
  requireNotNegative("radius", section.radius);
  requireNotNegative("young_modulus", section.young_modulus);
  requireNotNegative("shear_modulus", section.shear_modulus);
  requireNotNegative("width", section.width);
  requireNotNegative("height", section.height);
}

}  // namespace cable_variation
