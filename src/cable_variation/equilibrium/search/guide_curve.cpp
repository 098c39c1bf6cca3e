#include <cable_variation/equilibrium/search/guide_curve.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/math/so3.h>

namespace cable_variation {
namespace {

constexpr int kSamples = 24;

struct Bezier {
  Eigen::Vector3d p0, p1, p2, p3;

  Eigen::Vector3d at(double u) const {
    const double v = 1.0 - u;
    return v * v * v * p0 + 3.0 * v * v * u * p1 + 3.0 * v * u * u * p2 + u * u * u * p3;
  }
  Eigen::Vector3d slope(double u) const {
    const double v = 1.0 - u;
    return 3.0 * (v * v * (p1 - p0) + 2.0 * v * u * (p2 - p1) + u * u * (p3 - p2));
  }
  double length() const {
    double sum = 0.0;
    Eigen::Vector3d before = p0;
    for (int i = 1; i <= kSamples; ++i) {
      const Eigen::Vector3d here = at(static_cast<double>(i) / kSamples);
      sum += (here - before).norm();
      before = here;
    }
    return sum;
  }
};

// The parameter in [low, high] at which a growing function of it reaches `target`.
template <class Function>
double bisect(double low, double high, double target, Function function) {
  for (int i = 0; i < 24; ++i) {
    const double middle = 0.5 * (low + high);
    (function(middle) < target ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

GuideCurve GuideCurve::between(const GuideAnchor& a, const GuideAnchor& b, const Eigen::Vector3d& bulge,
                               const Eigen::Vector3d& fallback_bulge) {
  const double length = b.arc_length - a.arc_length;
  const Eigen::Vector3d chord = b.position - a.position;
  const Eigen::Vector3d direction = chord.norm() > 1e-9 * length
                                        ? Eigen::Vector3d(chord.normalized())
                                        : a.tangent.value_or(Eigen::Vector3d::UnitX());
  const Eigen::Vector3d ta = a.tangent.value_or(direction);
  const Eigen::Vector3d tb = b.tangent.value_or(direction);
  const auto curve = [&](double handle, const Eigen::Vector3d& aside) {
    return Bezier{a.position, a.position + handle * ta + aside, b.position - handle * tb + aside, b.position};
  };
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  Bezier bezier = curve(length / 3.0, none);
  if (bulge.isZero(0.0) && bezier.length() >= length) {
    const double handle =
        bisect(0.02 * length, length / 3.0, length, [&](double h) { return curve(h, none).length(); });
    bezier = curve(handle, none);
  } else {
    // longer handles bulge along the tangents; where these are along the chord they cannot
    const double room = 1.5 * length;
    if (bulge.isZero(0.0) && ta.cross(direction).norm() + tb.cross(direction).norm() > 0.2 &&
        curve(room, none).length() > length) {
      const double handle =
          bisect(length / 3.0, room, length, [&](double h) { return curve(h, none).length(); });
      bezier = curve(handle, none);
    } else {
      const Eigen::Vector3d aside = bulge.isZero(0.0) ? fallback_bulge : bulge;
      const double handle = length / 4.0;
      const double push =
          bisect(0.0, 2.0 * length, length, [&](double h) { return curve(handle, h * aside).length(); });
      bezier = curve(handle, push * aside);
    }
  }
  GuideCurve guide;
  double total = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const double u = static_cast<double>(i) / kSamples;
    Sample sample;
    sample.position = bezier.at(u);
    const Eigen::Vector3d slope = bezier.slope(u);
    sample.tangent = slope.norm() > 1e-12 ? Eigen::Vector3d(slope.normalized()) : direction;
    if (i > 0) total += (sample.position - guide.samples_.back().position).norm();
    sample.arc_length = total;
    sample.orientation.setIdentity();
    guide.samples_.push_back(sample);
  }
  for (Sample& sample : guide.samples_) sample.arc_length = a.arc_length + sample.arc_length / total * length;
  return guide;
}

GuideCurve GuideCurve::free(const RodProfile& cable, double arc_length, const Pose& pose, double length) {
  constexpr double kLargestTurn = 0.1;  // of a step [rad]
  const auto restCurvature = [&](double share) {
    return Eigen::Vector3d(cable.at(arc_length + share * length).rest_curvature);
  };
  double turn = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    turn += restCurvature((i + 0.5) / kSamples).norm() * std::abs(length) / kSamples;
  }
  const int steps = turn > 0.0 ? std::max(kSamples, static_cast<int>(std::ceil(turn / kLargestTurn))) : 1;
  const double step = length / steps;
  GuideCurve guide;
  Pose at = pose;
  for (int i = 0; i <= steps; ++i) {
    guide.samples_.push_back(
        {arc_length + i * step, at.position, at.orientation * Eigen::Vector3d::UnitX(), at.orientation});
    const Eigen::Vector3d bend = step * restCurvature((i + 0.5) / steps);
    at.position += step * (at.orientation * so3::exp(0.5 * bend) * Eigen::Vector3d::UnitX());
    at.orientation = (at.orientation * so3::exp(bend)).normalized();
  }
  if (length < 0.0) std::reverse(guide.samples_.begin(), guide.samples_.end());
  return guide;
}

GuideCurve GuideCurve::freeBetween(const RodProfile& cable, double arc_length, const Pose& first,
                                   const GuideAnchor& b) {
  const double length = b.arc_length - arc_length;
  GuideCurve guide = free(cable, arc_length, first, length);
  const GuideCurve from_end =
      b.orientation ? free(cable, b.arc_length, {b.position, *b.orientation}, -length) : GuideCurve();
  const Eigen::Vector3d gap = b.position - guide.samples_.back().position;
  std::vector<Sample> samples;
  for (const Sample& sample : guide.samples_) {
    const double t = (sample.arc_length - arc_length) / length;
    const double share = t * t * (3.0 - 2.0 * t);
    Sample blended = sample;
    if (b.orientation) {
      const Pose other = from_end.at(sample.arc_length);
      blended.position = (1.0 - share) * sample.position + share * other.position;
      blended.orientation = sample.orientation.slerp(share, other.orientation);
    } else {
      blended.position += share * gap;
    }
    blended.tangent = blended.orientation * Eigen::Vector3d::UnitX();
    samples.push_back(blended);
  }
  guide.samples_ = std::move(samples);
  return guide;
}

void GuideCurve::frame(const Eigen::Quaterniond& first, double twist) {
  Eigen::Vector3d tangent = first * Eigen::Vector3d::UnitX();
  Eigen::Quaterniond carried = first;
  for (Sample& sample : samples_) {
    carried = (so3::smallestRotation(tangent, sample.tangent) * carried).normalized();
    tangent = sample.tangent;
    sample.orientation = carried;
  }
  twist_ = twist;
}

double GuideCurve::twistTo(const Eigen::Quaterniond& first, const Eigen::Quaterniond& last) const {
  GuideCurve copy = *this;
  copy.frame(first, 0.0);
  const Eigen::Quaterniond difference = copy.samples_.back().orientation.conjugate() * last;
  const double angle = 2.0 * std::atan2(difference.x(), difference.w());
  return std::remainder(angle, 2.0 * M_PI);
}

Pose GuideCurve::at(double arc_length) const {
  const auto after = std::upper_bound(samples_.begin(), samples_.end(), arc_length,
                                      [](double s, const Sample& sample) { return s < sample.arc_length; });
  const auto index = std::clamp<std::ptrdiff_t>(after - samples_.begin(), 1,
                                                static_cast<std::ptrdiff_t>(samples_.size()) - 1);
  const Sample& b = samples_[static_cast<std::size_t>(index)];
  const Sample& a = samples_[static_cast<std::size_t>(index) - 1];
  const double h = b.arc_length - a.arc_length;
  const double t = h > 0.0 ? std::clamp((arc_length - a.arc_length) / h, 0.0, 1.0) : 0.0;
  // cubic Hermite in position: chords would start the rod with kinks
  const double t2 = t * t, t3 = t2 * t;
  const Eigen::Vector3d position = (2.0 * t3 - 3.0 * t2 + 1.0) * a.position +
                                   (t3 - 2.0 * t2 + t) * h * a.tangent + (3.0 * t2 - 2.0 * t3) * b.position +
                                   (t3 - t2) * h * b.tangent;
  const double share = (a.arc_length + t * h - start()) / (end() - start());
  const Eigen::Quaterniond twisted = so3::exp(Eigen::Vector3d(share * twist_, 0.0, 0.0));
  return {position, a.orientation.slerp(t, b.orientation) * twisted};
}

}  // namespace cable_variation
