#include <cable_variation/variation/section_loads.h>

#include <optional>

#include <Eigen/Geometry>

#include <cable_variation/harness/shape_point.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

// A vector and its first-order change.
struct Varied {
  Vector3d value, rate;
};
Varied operator+(const Varied& a, const Varied& b) { return {a.value + b.value, a.rate + b.rate}; }
Varied operator-(const Varied& a, const Varied& b) { return {a.value - b.value, a.rate - b.rate}; }
Varied operator-(const Varied& a) { return {-a.value, -a.rate}; }
Varied cross(const Varied& a, const Varied& b) {
  return {a.value.cross(b.value), a.rate.cross(b.value) + a.value.cross(b.rate)};
}
Varied times(const Varied& a, const Varied& b) {
  return {a.value.cwiseProduct(b.value), a.rate.cwiseProduct(b.value) + a.value.cwiseProduct(b.rate)};
}
Varied over(const Varied& a, const Varied& b) {
  const Vector3d quotient = a.value.cwiseQuotient(b.value);
  return {quotient, (a.rate - quotient.cwiseProduct(b.rate)).cwiseQuotient(b.value)};
}
Varied constant(const Vector3d& value) { return {value, Vector3d::Zero()}; }

// Force and moment at a section, in its frame, with two derivatives over s.
struct EndLoads {
  Varied force, force_slope, force_second;
  Varied moment, moment_slope, moment_second;
};

// n' = -Ω×n - ρA Rᵀg, m' = -Ω×m - Γ×n, and these differentiated once more.
EndLoads endLoads(const ShapePoint& point, const ShapePointRate& rate, const RodProperties& rod,
                  const RodProperties& rod_rate, const Vector3d& gravity) {
  const Eigen::Matrix3d to_section = point.pose.orientation.toRotationMatrix().transpose();
  const auto inSection = [&](const Vector3d& v, const Vector3d& v_rate) {
    return Varied{to_section * v, to_section * (v_rate - rate.rotation.cross(v))};
  };
  const Varied k_gamma{rod.stiffness.head<3>(), rod_rate.stiffness.head<3>()};
  const Varied k_omega{rod.stiffness.tail<3>(), rod_rate.stiffness.tail<3>()};
  const Varied k_gamma_slope{rod.stiffness_slope.head<3>(), rod_rate.stiffness_slope.head<3>()};
  const Varied k_omega_slope{rod.stiffness_slope.tail<3>(), rod_rate.stiffness_slope.tail<3>()};
  const Varied mass{Vector3d::Constant(rod.mass_per_length), Vector3d::Constant(rod_rate.mass_per_length)};
  const Varied mass_slope{Vector3d::Constant(rod.mass_slope), Vector3d::Constant(rod_rate.mass_slope)};

  EndLoads loads;
  const Varied n = loads.force = inSection(point.force, rate.force);
  const Varied m = loads.moment = inSection(point.moment, rate.moment);
  const Varied pull = inSection(gravity, Vector3d::Zero());
  const Varied strain = over(n, k_gamma), curvature = over(m, k_omega);
  const Varied gamma = constant(Vector3d::UnitX()) + strain;
  const Varied omega = curvature + Varied{rod.rest_curvature, rod_rate.rest_curvature};

  const Varied n1 = loads.force_slope = -cross(omega, n) - times(mass, pull);
  const Varied m1 = loads.moment_slope = -cross(omega, m) - cross(gamma, n);
  const Varied gamma1 = over(n1 - times(k_gamma_slope, strain), k_gamma);
  const Varied omega1 = over(m1 - times(k_omega_slope, curvature), k_omega) +
                        Varied{rod.rest_curvature_slope, rod_rate.rest_curvature_slope};
  loads.force_second =
      -cross(omega1, n) - cross(omega, n1) - times(mass_slope, pull) + times(mass, cross(omega, pull));
  loads.moment_second = -cross(omega1, m) - cross(omega, m1) - cross(gamma1, n) - cross(gamma, n1);
  return loads;
}

EndLoads unvaried(const ShapePoint& point, const RodProperties& rod, const Vector3d& gravity) {
  static const ShapePointRate none;
  static const RodProperties no_change{Vector6d::Zero(),
                                       Vector6d::Zero(),
                                       Vector3d::Zero(),
                                       Vector3d::Zero(),
                                       Vector3d::Zero(),
                                       0.0,
                                       0.0,
                                       0.0};
  return endLoads(point, none, rod, no_change, gravity);
}

}  // namespace

SectionLoads::SectionLoads(const CableView& view, std::size_t index, const Vector3d& gravity)
    : SectionLoads([&] {
        const CableView::Piece& piece = view.pieces()[index];
        const EndLoads a = unvaried(view.start(index), piece.start, gravity);
        const EndLoads b = unvaried(view.end(index), piece.end, gravity);
        return SectionLoads(
            CurvePiece({a.force.value, a.force_slope.value, a.force_second.value},
                       {b.force.value, b.force_slope.value, b.force_second.value}, piece.length),
            CurvePiece({a.moment.value, a.moment_slope.value, a.moment_second.value},
                       {b.moment.value, b.moment_slope.value, b.moment_second.value}, piece.length));
      }()) {
  stiffness_start_ = view.pieces()[index].start.stiffness;
  stiffness_end_ = view.pieces()[index].end.stiffness;
}

Eigen::Matrix<double, 6, 1> SectionLoads::stiffness(double t) const {
  return (1.0 - t) * stiffness_start_ + t * stiffness_end_;
}

std::vector<SectionLoads> SectionLoads::ratesAlong(const CableView& view, std::size_t first, std::size_t last,
                                                   const Vector3d& gravity, const CableRates& rates) {
  struct End {
    EndLoads loads;
    Eigen::Matrix<double, 6, 1> stiffness_rate;
  };
  const auto endOf = [&](const ShapePoint& point, const ShapePointRate& rate, const RodProperties& rod) {
    const RodProperties rod_rate = propertyRate(rod, point.arc_length, rates.cable, rate.arc_length);
    return End{endLoads(point, rate, rod, rod_rate, gravity), rod_rate.stiffness};
  };
  std::vector<SectionLoads> changes;
  changes.reserve(last - first + 1);
  std::optional<End> before;
  for (std::size_t i = first; i <= last; ++i) {
    const CableView::Piece& piece = view.pieces()[i];
    const bool shared = before && view.pieces()[i - 1].point + 1 == piece.point;
    const End a = shared ? *before : endOf(view.start(i), view.start(i, rates), piece.start);
    const End b = endOf(view.end(i), view.end(i, rates), piece.end);
    const double stretch = (view.end(i, rates).arc_length - view.start(i, rates).arc_length) / piece.length;
    // derivatives over s become those over t by the piece's length, which changes too
    const auto curveEnd = [&](const Varied& value, const Varied& slope, const Varied& second) {
      return CurvePiece::End{value.rate, slope.rate + stretch * slope.value,
                             second.rate + 2.0 * stretch * second.value};
    };
    changes.push_back(SectionLoads(
        CurvePiece(curveEnd(a.loads.force, a.loads.force_slope, a.loads.force_second),
                   curveEnd(b.loads.force, b.loads.force_slope, b.loads.force_second), piece.length),
        CurvePiece(curveEnd(a.loads.moment, a.loads.moment_slope, a.loads.moment_second),
                   curveEnd(b.loads.moment, b.loads.moment_slope, b.loads.moment_second), piece.length)));
    changes.back().stiffness_start_ = a.stiffness_rate;
    changes.back().stiffness_end_ = b.stiffness_rate;
    before = b;
  }
  return changes;
}

}  // namespace cable_variation
