#include <cable_variation/harness/guide_curve.h>

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

GuideCurve GuideCurve::straight(double arc_length, const Pose& pose, double length) {
  const Eigen::Vector3d tangent = pose.orientation * Eigen::Vector3d::UnitX();
  GuideCurve guide;
  for (double s : {0.0, 1.0}) {
    guide.samples_.push_back(
        {arc_length + s * length, pose.position + s * length * tangent, tangent, pose.orientation});
  }
  if (length < 0.0) std::reverse(guide.samples_.begin(), guide.samples_.end());
  return guide;
}

void GuideCurve::frame(const Eigen::Quaterniond& first, double twist) {
  Eigen::Vector3d tangent = first * Eigen::Vector3d::UnitX();
  Eigen::Quaterniond carried = first;
  for (Sample& sample : samples_) {
    carried = (so3::smallestRotation(tangent, sample.tangent) * carried).normalized();
    tangent = sample.tangent;
    const double share = (sample.arc_length - start()) / (end() - start());
    sample.orientation = carried * so3::exp(Eigen::Vector3d(share * twist, 0.0, 0.0));
  }
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
  return {position, a.orientation.slerp(t, b.orientation)};
}

}  // namespace cable_variation
