#include <cable_variation/equilibrium/discretisation/shape_point.h>

namespace cable_variation {

using Eigen::Vector3d;

ShapePoint shapePoint(double arc_length, const Pose& pose, const Vector6d& section_force,
                      const RodProperties& rod, const Vector3d& gravity) {
  ShapePoint point;
  point.arc_length = arc_length;
  point.pose = pose;
  point.force = section_force.head<3>();
  const Vector3d m = section_force.tail<3>();
  point.moment = pose.orientation * m;
  const Vector3d n = pose.orientation.conjugate() * point.force;
  const Vector3d k_gamma = rod.stiffness.head<3>();
  const Vector3d k_omega = rod.stiffness.tail<3>();
  point.strain = n.cwiseQuotient(k_gamma);
  point.curvature = m.cwiseQuotient(k_omega);
  point.darboux = point.curvature + rod.rest_curvature;
  const Vector3d gamma = Vector3d::UnitX() + point.strain;
  point.tangent = pose.orientation * gamma;
  // n' in the section frame: -Ω × n - ρA Rᵀg; stiffness may change along s
  const Vector3d weight = pose.orientation.conjugate() * (rod.mass_per_length * gravity);
  const Vector3d n_slope = -point.darboux.cross(n) - weight;
  const Vector3d stiffness_slope = rod.stiffness_slope.head<3>();
  const Vector3d gamma_slope = (n_slope - stiffness_slope.cwiseProduct(point.strain)).cwiseQuotient(k_gamma);
  point.second_derivative = pose.orientation * (point.darboux.cross(gamma) + gamma_slope);
  return point;
}

RodProperties propertyRate(const RodProperties& rod, double arc_length, const CableRate& cable,
                           double arc_length_rate) {
  const double along = arc_length_rate - cable.knots * arc_length;
  RodProperties rate;
  rate.stiffness = rod.stiffness.cwiseProduct(cable.stiffness) + along * rod.stiffness_slope;
  rate.stiffness_slope =
      rod.stiffness_slope.cwiseProduct(cable.stiffness) - cable.knots * rod.stiffness_slope;
  rate.rest_curvature = cable.rest_curvature * rod.rest_curvature + along * rod.rest_curvature_slope;
  rate.rest_curvature_slope =
      (cable.rest_curvature - cable.knots) * rod.rest_curvature_slope + along * rod.rest_curvature_second;
  rate.rest_curvature_second = Vector3d::Zero();
  rate.mass_per_length = cable.mass * rod.mass_per_length + along * rod.mass_slope;
  rate.mass_slope = (cable.mass - cable.knots) * rod.mass_slope;
  rate.radius = cable.radius * rod.radius;
  return rate;
}

ShapePointRate shapePointRate(const ShapePoint& point, const Vector6d& motion, const Vector6d& force_rate,
                              double arc_length_rate, const RodProperties& rod, const RodProperties& rod_rate,
                              const Vector3d& gravity) {
  const Eigen::Matrix3d R = point.pose.orientation.toRotationMatrix();
  const Vector3d k_gamma = rod.stiffness.head<3>(), k_omega = rod.stiffness.tail<3>();
  const Vector3d dk_gamma = rod_rate.stiffness.head<3>(), dk_omega = rod_rate.stiffness.tail<3>();
  const Vector3d turn = motion.tail<3>();
  ShapePointRate rate;
  rate.arc_length = arc_length_rate;
  rate.position = motion.head<3>();
  rate.rotation = R * turn;
  rate.force = force_rate.head<3>();
  rate.moment = force_rate.tail<3>();

  // in the section frame, which turns itself
  const Vector3d n = R.transpose() * point.force, m = R.transpose() * point.moment;
  const Vector3d dn = R.transpose() * rate.force - turn.cross(n);
  const Vector3d dm = R.transpose() * rate.moment - turn.cross(m);
  rate.strain = (dn - point.strain.cwiseProduct(dk_gamma)).cwiseQuotient(k_gamma);
  rate.curvature = (dm - point.curvature.cwiseProduct(dk_omega)).cwiseQuotient(k_omega);
  const Vector3d omega_rate = rate.curvature + rod_rate.rest_curvature;

  const Vector3d gamma = Vector3d::UnitX() + point.strain;
  rate.tangent = R * (turn.cross(gamma) + rate.strain);
  const Vector3d pull = R.transpose() * gravity;
  const Vector3d n_slope = -point.darboux.cross(n) - rod.mass_per_length * pull;
  const Vector3d n_slope_rate = -omega_rate.cross(n) - point.darboux.cross(dn) -
                                rod_rate.mass_per_length * pull + rod.mass_per_length * turn.cross(pull);
  const Vector3d k_slope = rod.stiffness_slope.head<3>(), dk_slope = rod_rate.stiffness_slope.head<3>();
  const Vector3d gamma_slope = (n_slope - k_slope.cwiseProduct(point.strain)).cwiseQuotient(k_gamma);
  const Vector3d gamma_slope_rate = (n_slope_rate - dk_slope.cwiseProduct(point.strain) -
                                     k_slope.cwiseProduct(rate.strain) - gamma_slope.cwiseProduct(dk_gamma))
                                        .cwiseQuotient(k_gamma);
  const Vector3d bend = point.darboux.cross(gamma) + gamma_slope;
  rate.second_derivative =
      R * (turn.cross(bend) + omega_rate.cross(gamma) + point.darboux.cross(rate.strain) + gamma_slope_rate);
  return rate;
}

}  // namespace cable_variation
