#include <cable_variation/measures/measure_strength.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <cable_variation/measures/largest_over.h>
#include <cable_variation/measures/section_loads.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

// What strains and stresses depend on beside the loads.
struct SectionSize {
  double radius, width, height, young_modulus, shear_modulus;

  explicit SectionSize(const Section& s)
      : radius(s.radius),
        width(s.width),
        height(s.height),
        young_modulus(s.young_modulus),
        shear_modulus(s.shear_modulus) {}
  bool rectangle() const { return width > 0.0 && height > 0.0; }
};

// Each member a + factor × b.
SectionSize combine(const SectionSize& a, double factor, const SectionSize& b) {
  SectionSize c = a;
  c.radius += factor * b.radius;
  c.width += factor * b.width;
  c.height += factor * b.height;
  c.young_modulus += factor * b.young_modulus;
  c.shear_modulus += factor * b.shear_modulus;
  return c;
}

// At a place, and how it changes there.
struct SizeAt {
  SectionSize value, rate;
};

SectionSize sizeAt(const CableView& view, const Place& place) {
  // inside the piece: at its ends the section may step
  const double t = std::clamp(place.t, 1e-9, 1.0 - 1e-9);
  return SectionSize(sectionAt(view.cable(), view.arcLength({place.piece, t})));
}

SectionSize sizeRate(const CableView& view, const Place& place, const CableRates& rates) {
  const SectionSize start = sizeAt(view, {place.piece, 0.0}), end = sizeAt(view, {place.piece, 1.0});
  const double along = view.arcLengthRate(place, rates) - rates.cable.knots * view.arcLength(place);
  // over the arc length; then the cable's own change, which leaves the material
  SectionSize rate = combine(end, -1.0, start);
  rate = combine(rate, along / view.pieces()[place.piece].length - 1.0, rate);
  const SectionSize here = sizeAt(view, place);
  rate.radius += rates.cable.radius * here.radius;
  rate.width += rates.cable.radius * here.width;
  rate.height += rates.cable.radius * here.height;
  return rate;
}

double sign(double x) { return x < 0.0 ? -1.0 : 1.0; }

// The change of hypot(x, y); of one that is zero, of its size.
double hypotRate(double x, double y, double x_rate, double y_rate) {
  const double size = std::hypot(x, y);
  return size > 0.0 ? (x * x_rate + y * y_rate) / size : std::hypot(x_rate, y_rate);
}

// As std::hypot(), a tenth of its time: strains and curvatures are far from overflow.
double length(double x, double y) { return std::sqrt(x * x + y * y); }

// Largest normal strain and shear strain at a section's surface.
struct SurfaceStrain {
  double normal, shear;
};

// Where the shear of torsion is at most torsion times this.
double torsionArm(const SectionSize& size) {
  return size.rectangle() ? std::min({size.width, size.height, size.radius}) : size.radius;
}

SurfaceStrain surfaceStrain(const Vector3d& strain, const Vector3d& curvature, const SectionSize& size) {
  const double bending =
      size.rectangle() ? 0.5 * (size.height * std::abs(curvature.y()) + size.width * std::abs(curvature.z()))
                       : size.radius * length(curvature.y(), curvature.z());
  return {std::abs(strain.x()) + bending,
          torsionArm(size) * std::abs(curvature.x()) + length(strain.y(), strain.z())};
}

SurfaceStrain surfaceStrainRate(const Vector3d& strain, const Vector3d& curvature, const SectionSize& size,
                                const Vector3d& strain_rate, const Vector3d& curvature_rate,
                                const SectionSize& rate) {
  const Vector3d& k = curvature;
  const Vector3d& dk = curvature_rate;
  const double bending =
      size.rectangle()
          ? 0.5 * (rate.height * std::abs(k.y()) + size.height * sign(k.y()) * dk.y() +
                   rate.width * std::abs(k.z()) + size.width * sign(k.z()) * dk.z())
          : rate.radius * std::hypot(k.y(), k.z()) + size.radius * hypotRate(k.y(), k.z(), dk.y(), dk.z());
  const double arm = torsionArm(size);
  const double arm_rate = !size.rectangle() || arm == size.radius ? rate.radius
                          : arm == size.width                     ? rate.width
                                                                  : rate.height;
  return {sign(strain.x()) * strain_rate.x() + bending,
          arm_rate * std::abs(k.x()) + arm * sign(k.x()) * dk.x() +
              hypotRate(strain.y(), strain.z(), strain_rate.y(), strain_rate.z())};
}

double equivalentStress(const SurfaceStrain& strain, const SectionSize& size) {
  return std::hypot(size.young_modulus * strain.normal, std::sqrt(3.0) * size.shear_modulus * strain.shear);
}

Vector3d strainOf(const Vector3d& load, const Vector3d& stiffness) { return load.cwiseQuotient(stiffness); }

Vector3d strainRateOf(const Vector3d& load, const Vector3d& stiffness, const Vector3d& load_rate,
                      const Vector3d& stiffness_rate) {
  return (load_rate - load.cwiseQuotient(stiffness).cwiseProduct(stiffness_rate)).cwiseQuotient(stiffness);
}

double componentOf(const Measure& measure, const Vector3d& load) {
  return measure.axis ? load[static_cast<int>(*measure.axis)] : load.norm();
}

Vector3d loadOf(const Measure& measure, const SectionLoads& loads, double t) {
  return measure.type == Measure::Type::section_force ? loads.force(t) : loads.moment(t);
}

// Gauss and Legendre's four points on [0, 1]: exact for the quintic moment over a uniform stiffness.
struct GaussPoint {
  double at, weight;
};
constexpr GaussPoint kGauss[] = {{0.069431844202973712, 0.173927422568726929},
                                 {0.330009478207571868, 0.326072577431273071},
                                 {0.669990521792428132, 0.326072577431273071},
                                 {0.930568155797026288, 0.173927422568726929}};

}  // namespace

MeasureValue strengthValue(const MeasureContext& context, const Measure& measure) {
  return largestOver(context, measure, [&](std::size_t cable) {
    const CableView& view = context.cables[cable];
    std::vector<std::pair<SectionSize, SectionSize>> sizes;  // at the pieces' ends, linear between
    for (std::size_t i = 0; i < view.pieces().size(); ++i)
      sizes.emplace_back(sizeAt(view, {i, 0.0}), sizeAt(view, {i, 1.0}));
    return [&measure, sizes, &loads = context.loads(cable)](std::size_t piece, double t) {
      const Vector6d k = loads[piece].stiffness(t);
      const auto& [start, end] = sizes[piece];
      const SectionSize size = combine(start, t, combine(end, -1.0, start));
      const SurfaceStrain strain = surfaceStrain(strainOf(loads[piece].force(t), k.head<3>()),
                                                 strainOf(loads[piece].moment(t), k.tail<3>()), size);
      return measure.type == Measure::Type::strain ? strain.normal : equivalentStress(strain, size);
    };
  });
}

RateOfMeasure strengthRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value) {
  const CableView& view = context.cables[value.cable];
  const Place place = value.trace.place;
  const SectionLoads loads(view, place.piece, context.at.harness.gravity);
  const double t = place.t;
  const Vector6d k = loads.stiffness(t);
  const Vector3d force = loads.force(t), moment = loads.moment(t);
  const Vector3d strain = strainOf(force, k.head<3>()), curvature = strainOf(moment, k.tail<3>());
  const SectionSize size = sizeAt(view, place);
  const bool only_strain = measure.type == Measure::Type::strain;
  return [=, &view, cable_index = value.cable](const MeasureRates& rates) {
    const CableRates cable = rates.cable(cable_index);
    const SectionLoads::Rate change = loads.rate(cable);
    const Vector6d dk = change.stiffness(t);
    const SectionSize size_rate = sizeRate(view, place, cable);
    const SurfaceStrain rate = surfaceStrainRate(
        strain, curvature, size, strainRateOf(force, k.head<3>(), change.force(t), dk.head<3>()),
        strainRateOf(moment, k.tail<3>(), change.moment(t), dk.tail<3>()), size_rate);
    if (only_strain) return rate.normal;
    const SurfaceStrain at_surface = surfaceStrain(strain, curvature, size);
    const double E = size.young_modulus, G = std::sqrt(3.0) * size.shear_modulus;
    return hypotRate(E * at_surface.normal, G * at_surface.shear,
                     E * rate.normal + size_rate.young_modulus * at_surface.normal,
                     G * rate.shear + std::sqrt(3.0) * size_rate.shear_modulus * at_surface.shear);
  };
}

MeasureValue sectionLoadValue(const MeasureContext& context, const Measure& measure) {
  if (measure.arc_length) {
    const std::size_t cable = measure.cables.front();
    const NamedPlace named(context, cable, *measure.arc_length);
    const SectionLoads& loads = context.loads(cable)[named.place.piece];
    return measureAt(context, cable, named.place,
                     componentOf(measure, loadOf(measure, loads, named.place.t)));
  }
  MeasureValue largest = largestOver(context, measure, [&](std::size_t cable) {
    return [&measure, &loads = context.loads(cable)](std::size_t piece, double t) {
      return std::abs(componentOf(measure, loadOf(measure, loads[piece], t)));
    };
  });
  if (measure.axis) {
    const Place& place = largest.trace.place;
    const SectionLoads& loads = context.loads(largest.cable)[place.piece];
    largest.value = componentOf(measure, loadOf(measure, loads, place.t));
  }
  return largest;
}

RateOfMeasure sectionLoadRate(const MeasureContext& context, const Measure& measure,
                              const MeasureValue& value) {
  const CableView& view = context.cables[value.cable];
  const Place place = value.trace.place;
  const SectionLoads loads(view, place.piece, context.at.harness.gravity);
  const bool force = measure.type == Measure::Type::section_force;
  const Vector3d load = loadOf(measure, loads, place.t);
  const Vector3d slope = force ? loads.forceSlope(place.t) : loads.momentSlope(place.t);
  std::optional<NamedPlace> named;
  if (measure.arc_length) named.emplace(context, value.cable, *measure.arc_length);
  return [=, &view, axis = measure.axis, cable_index = value.cable](const MeasureRates& rates) {
    const CableRates cable = rates.cable(cable_index);
    const SectionLoads::Rate change = loads.rate(cable);
    Vector3d rate = force ? change.force(place.t) : change.moment(place.t);
    if (named) rate += named->shareRate(view, cable) * slope;
    if (axis) return rate[static_cast<int>(*axis)];
    return load.isZero(0.0) ? rate.norm() : load.normalized().dot(rate);
  };
}

namespace {

// A stretch of a piece that counts for the twist, with the torsion at its Gauss points.
struct TwistedStretch {
  std::size_t piece;
  double start, end;  ///< t
  double length;      ///< of the piece [m]
  SectionLoads loads;
  std::array<double, 4> t, torsion, stiffness;  ///< torsion [1/m], GJ [N m²]
  double torsion_at_start, torsion_at_end;      ///< [1/m]

  TwistedStretch(const MeasureContext& context, const CableView& view, std::size_t index, double from,
                 double to)
      : piece(index),
        start(from),
        end(to),
        length(view.pieces()[index].length),
        loads(view, index, context.at.harness.gravity) {
    for (std::size_t g = 0; g < t.size(); ++g) {
      t[g] = from + kGauss[g].at * (to - from);
      stiffness[g] = loads.stiffness(t[g])[3];
      torsion[g] = loads.moment(t[g]).x() / stiffness[g];
    }
    torsion_at_start = loads.moment(from).x() / loads.stiffness(from)[3];
    torsion_at_end = loads.moment(to).x() / loads.stiffness(to)[3];
  }
};

std::vector<TwistedStretch> twistedStretches(const MeasureContext& context, const CableView& view,
                                             const Place& from, const Place& to) {
  std::vector<TwistedStretch> stretches;
  stretches.reserve(to.piece - from.piece + 1);
  for (std::size_t i = from.piece; i <= to.piece; ++i) {
    stretches.emplace_back(context, view, i, i == from.piece ? from.t : 0.0, i == to.piece ? to.t : 1.0);
  }
  return stretches;
}

}  // namespace

MeasureValue twistValue(const MeasureContext& context, const Measure& measure) {
  const std::size_t cable = measure.cables.front();
  const CableView& view = context.cables[cable];
  const NamedPlace from(context, cable, measure.from), to(context, cable, measure.to);
  double twist = 0.0;
  for (const TwistedStretch& stretch : twistedStretches(context, view, from.place, to.place)) {
    for (std::size_t g = 0; g < stretch.t.size(); ++g)
      twist += kGauss[g].weight * (stretch.end - stretch.start) * stretch.length * stretch.torsion[g];
  }
  return measureAt(context, cable, to.place, twist);
}

RateOfMeasure twistRate(const MeasureContext& context, const Measure& measure) {
  const std::size_t index = measure.cables.front();
  const CableView& view = context.cables[index];
  const NamedPlace from(context, index, measure.from), to(context, index, measure.to);
  return [=, &view,
          stretches = twistedStretches(context, view, from.place, to.place)](const MeasureRates& rates) {
    const CableRates cable = rates.cable(index);
    double rate = 0.0;
    for (const TwistedStretch& stretch : stretches) {
      const SectionLoads::Rate change = stretch.loads.rate(cable);
      const CurvePiece moment = change.momentCurve();
      for (std::size_t g = 0; g < stretch.t.size(); ++g) {
        const double t = stretch.t[g], torsion = stretch.torsion[g];
        const double stiffness_rate = (1.0 - t) * change.stiffness_start[3] + t * change.stiffness_end[3];
        const double torsion_rate =
            (moment.position(t).x() - torsion * stiffness_rate) / stretch.stiffness[g];
        rate += kGauss[g].weight * (stretch.end - stretch.start) *
                (stretch.length * torsion_rate + change.length * torsion);
      }
    }
    const TwistedStretch &first = stretches.front(), &last = stretches.back();
    return rate - first.length * first.torsion_at_start * from.shareRate(view, cable) +
           last.length * last.torsion_at_end * to.shareRate(view, cable);
  };
}

}  // namespace cable_variation
