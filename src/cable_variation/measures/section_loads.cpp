#include <cable_variation/measures/section_loads.h>

#include <Eigen/Geometry>

#include <cable_variation/equilibrium/discretisation/shape_point.h>

namespace cable_variation {

using Eigen::Vector3d;

SectionLoads::End SectionLoads::loadsAt(const ShapePoint& point, const RodProperties& rod,
                                        const Vector3d& gravity) {
  const Vector3d k_gamma = rod.stiffness.head<3>(), k_omega = rod.stiffness.tail<3>();
  End end;
  end.arc_length = point.arc_length;
  end.to_section = point.pose.orientation.toRotationMatrix().transpose();
  end.pull = end.to_section * gravity;
  const Vector3d n = end.force = end.to_section * point.force;
  const Vector3d m = end.moment = end.to_section * point.moment;
  end.strain = n.cwiseQuotient(k_gamma);
  end.curvature = m.cwiseQuotient(k_omega);
  end.gamma = Vector3d::UnitX() + end.strain;
  end.omega = end.curvature + rod.rest_curvature;

  const Vector3d n1 = end.force_slope = -end.omega.cross(n) - rod.mass_per_length * end.pull;
  const Vector3d m1 = end.moment_slope = -end.omega.cross(m) - end.gamma.cross(n);
  end.gamma_slope = (n1 - rod.stiffness_slope.head<3>().cwiseProduct(end.strain)).cwiseQuotient(k_gamma);
  end.curvature_slope =
      (m1 - rod.stiffness_slope.tail<3>().cwiseProduct(end.curvature)).cwiseQuotient(k_omega);
  end.omega_slope = end.curvature_slope + rod.rest_curvature_slope;
  end.force_second = -end.omega_slope.cross(n) - end.omega.cross(n1) - rod.mass_slope * end.pull +
                     rod.mass_per_length * end.omega.cross(end.pull);
  end.moment_second =
      -end.omega_slope.cross(m) - end.omega.cross(m1) - end.gamma_slope.cross(n) - end.gamma.cross(n1);
  return end;
}

// loadsAt() line by line, by the product rule.
PointLoads SectionLoads::loadRates(const End& at, const RodProperties& rod, const RodProperties& rod_rate,
                                   const ShapePointRate& rate) {
  const Vector3d k_gamma = rod.stiffness.head<3>(), k_omega = rod.stiffness.tail<3>();
  const Vector3d dk_gamma = rod_rate.stiffness.head<3>(), dk_omega = rod_rate.stiffness.tail<3>();
  const Vector3d &n = at.force, &m = at.moment, &n1 = at.force_slope, &m1 = at.moment_slope;
  const Vector3d turn = at.to_section * rate.rotation;
  const Vector3d pull = -turn.cross(at.pull);
  const Vector3d& gamma = rate.strain;
  const Vector3d omega = rate.curvature + rod_rate.rest_curvature;

  PointLoads d;
  d.force = at.to_section * rate.force - turn.cross(n);
  d.moment = at.to_section * rate.moment - turn.cross(m);
  d.force_slope = -omega.cross(n) - at.omega.cross(d.force) - rod_rate.mass_per_length * at.pull -
                  rod.mass_per_length * pull;
  d.moment_slope = -omega.cross(m) - at.omega.cross(d.moment) - gamma.cross(n) - at.gamma.cross(d.force);
  const Vector3d gamma_slope =
      (d.force_slope - rod_rate.stiffness_slope.head<3>().cwiseProduct(at.strain) -
       rod.stiffness_slope.head<3>().cwiseProduct(gamma) - dk_gamma.cwiseProduct(at.gamma_slope))
          .cwiseQuotient(k_gamma);
  const Vector3d omega_slope =
      (d.moment_slope - rod_rate.stiffness_slope.tail<3>().cwiseProduct(at.curvature) -
       rod.stiffness_slope.tail<3>().cwiseProduct(rate.curvature) - dk_omega.cwiseProduct(at.curvature_slope))
          .cwiseQuotient(k_omega) +
      rod_rate.rest_curvature_slope;
  d.force_second = -omega_slope.cross(n) - at.omega_slope.cross(d.force) - omega.cross(n1) -
                   at.omega.cross(d.force_slope) - rod_rate.mass_slope * at.pull - rod.mass_slope * pull +
                   rod_rate.mass_per_length * at.omega.cross(at.pull) +
                   rod.mass_per_length * (omega.cross(at.pull) + at.omega.cross(pull));
  d.moment_second = -omega_slope.cross(m) - at.omega_slope.cross(d.moment) - omega.cross(m1) -
                    at.omega.cross(d.moment_slope) - gamma_slope.cross(n) - at.gamma_slope.cross(d.force) -
                    gamma.cross(n1) - at.gamma.cross(d.force_slope);
  return d;
}

SectionLoads::SectionLoads(const CableView& view, std::size_t piece, const Vector3d& gravity)
    : point_(view.pieces()[piece].point),
      length_(view.pieces()[piece].length),
      rod_start_(view.pieces()[piece].start),
      rod_end_(view.pieces()[piece].end),
      stiffness_start_(rod_start_.stiffness),
      stiffness_end_(rod_end_.stiffness),
      start_(loadsAt(view.start(piece), rod_start_, gravity)),
      end_(loadsAt(view.end(piece), rod_end_, gravity)),
      force_({start_.force, start_.force_slope, start_.force_second},
             {end_.force, end_.force_slope, end_.force_second}, length_),
      moment_({start_.moment, start_.moment_slope, start_.moment_second},
              {end_.moment, end_.moment_slope, end_.moment_second}, length_) {}

SectionLoads::Rate SectionLoads::rate(const CableRates& rates) const {
  const ShapePointRate &start = rates.points[point_], &end = rates.points[point_ + 1];
  const RodProperties rod_start = propertyRate(rod_start_, start_.arc_length, rates.cable, start.arc_length);
  const RodProperties rod_end = propertyRate(rod_end_, end_.arc_length, rates.cable, end.arc_length);
  Rate rate;
  rate.piece_length = length_;
  rate.length = end.arc_length - start.arc_length;
  rate.stiffness_start = rod_start.stiffness;
  rate.stiffness_end = rod_end.stiffness;
  rate.start = loadRates(start_, rod_start_, rod_start, start);
  rate.end = loadRates(end_, rod_end_, rod_end, end);
  // derivatives over s become those over t by the piece's length, which changes too
  const double stretch = rate.length / length_;
  const auto stretched = [&](PointLoads& loads, const PointLoads& at) {
    loads.force_slope += stretch * at.force_slope;
    loads.force_second += 2.0 * stretch * at.force_second;
    loads.moment_slope += stretch * at.moment_slope;
    loads.moment_second += 2.0 * stretch * at.moment_second;
  };
  if (stretch != 0.0) {
    stretched(rate.start, start_);
    stretched(rate.end, end_);
  }
  return rate;
}

CurvePiece SectionLoads::Rate::forceCurve() const {
  return {{start.force, start.force_slope, start.force_second},
          {end.force, end.force_slope, end.force_second},
          piece_length};
}

CurvePiece SectionLoads::Rate::momentCurve() const {
  return {{start.moment, start.moment_slope, start.moment_second},
          {end.moment, end.moment_slope, end.moment_second},
          piece_length};
}

}  // namespace cable_variation
