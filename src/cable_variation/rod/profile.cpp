#include <cable_variation/rod/profile.h>

#include <algorithm>

namespace cable_variation {
namespace {

Eigen::Matrix<double, 6, 1> stiffnessOf(const Section& s) {
  Eigen::Matrix<double, 6, 1> k;
  k << s.EA, s.GA_y, s.GA_z, s.GJ, s.EI_y, s.EI_z;
  return k;
}

// Index of the piece [knots[i], knots[i + 1]] that holds s; there are at least two knots.
template <class Knots>
std::size_t pieceAt(const Knots& knots, double s) {
  const auto after = std::upper_bound(knots.begin(), knots.end(), s,
                                      [](double value, const auto& knot) { return value < knot.arc_length; });
  const auto index = static_cast<std::size_t>(after - knots.begin());
  return std::clamp<std::size_t>(index, 1, knots.size() - 1) - 1;
}

}  // namespace

RodProfile::RodProfile(const Cable& cable) : length_(cable.length), sections_(cable.sections) {
  const auto& knots = cable.rest_curvature;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    curvature_.push_back(
        {knots[i].arc_length, knots[i].curvature, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  }
  const auto step = [&](std::size_t i) { return knots[i + 1].arc_length - knots[i].arc_length; };
  const auto secant = [&](std::size_t i) -> Eigen::Vector3d {
    return (knots[i + 1].curvature - knots[i].curvature) / step(i);
  };
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const bool before = i > 0 && step(i - 1) > 0.0;
    const bool after = i + 1 < knots.size() && step(i) > 0.0;
    CurvatureKnot& knot = curvature_[i];
    if (before && after) {
      const double a = step(i - 1), b = step(i);
      knot.slope_before = knot.slope_after = (b * secant(i - 1) + a * secant(i)) / (a + b);
    } else if (before) {
      knot.slope_before = secant(i - 1);
    } else if (after) {
      knot.slope_after = secant(i);
    }
  }
}

RodProperties RodProfile::at(double arc_length) const {
  RodProperties p;
  if (sections_.size() == 1 || arc_length < sections_.front().arc_length ||
      arc_length > sections_.back().arc_length) {
    const Section& s =
        arc_length < sections_.front().arc_length ? sections_.front().section : sections_.back().section;
    p.stiffness = stiffnessOf(s);
    p.stiffness_slope.setZero();
    p.mass_per_length = s.mass_per_length;
    p.mass_slope = 0.0;
    p.radius = s.radius;
  } else {
    const std::size_t i = pieceAt(sections_, arc_length);
    const SectionAt& a = sections_[i];
    const SectionAt& b = sections_[i + 1];
    const double step = b.arc_length - a.arc_length;
    const double inverse = step > 0.0 ? 1.0 / step : 0.0;
    const Section s =
        interpolate(a.section, b.section, step > 0.0 ? (arc_length - a.arc_length) * inverse : 1.0);
    p.stiffness = stiffnessOf(s);
    p.stiffness_slope = inverse * (stiffnessOf(b.section) - stiffnessOf(a.section));
    p.mass_per_length = s.mass_per_length;
    p.mass_slope = inverse * (b.section.mass_per_length - a.section.mass_per_length);
    p.radius = s.radius;
  }
  p.rest_curvature.setZero();
  p.rest_curvature_slope.setZero();
  p.rest_curvature_second.setZero();
  if (curvature_.size() == 1) p.rest_curvature = curvature_.front().value;
  if (curvature_.size() > 1) {
    const std::size_t i = pieceAt(curvature_, arc_length);
    const CurvatureKnot& a = curvature_[i];
    const CurvatureKnot& b = curvature_[i + 1];
    if (arc_length <= a.arc_length) {
      p.rest_curvature = a.value;
    } else if (arc_length >= b.arc_length) {
      p.rest_curvature = b.value;
    } else {
      const double h = b.arc_length - a.arc_length;
      const double t = (arc_length - a.arc_length) / h;
      const Eigen::Vector3d d = b.value - a.value;
      const Eigen::Vector3d m0 = h * a.slope_after;
      const Eigen::Vector3d m1 = h * b.slope_before;
      const Eigen::Vector3d c2 = 3.0 * d - 2.0 * m0 - m1;
      const Eigen::Vector3d c3 = m0 + m1 - 2.0 * d;
      p.rest_curvature = a.value + t * (m0 + t * (c2 + t * c3));
      p.rest_curvature_slope = (m0 + t * (2.0 * c2 + 3.0 * t * c3)) / h;
      p.rest_curvature_second = (2.0 * c2 + 6.0 * t * c3) / (h * h);
    }
  }
  return p;
}

std::vector<double> RodProfile::breaks() const {
  std::vector<double> places;
  for (const SectionAt& s : sections_) places.push_back(s.arc_length);
  for (std::size_t i = 1; i < curvature_.size(); ++i) {
    if (curvature_[i].arc_length == curvature_[i - 1].arc_length) places.push_back(curvature_[i].arc_length);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  places.erase(
      std::remove_if(places.begin(), places.end(), [&](double s) { return s <= 0.0 || s >= length_; }),
      places.end());
  return places;
}

}  // namespace cable_variation
