#include <cable_variation/geometry/tube_distance/nearest_place.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cable_variation {

using Eigen::Vector3d;

ControlPoints controlPoints(const PieceEnd& start, const PieceEnd& end, double dt) {
  const Vector3d first_a = dt / 5.0 * start.first, first_b = dt / 5.0 * end.first;
  const Vector3d second_a = dt * dt / 20.0 * start.second, second_b = dt * dt / 20.0 * end.second;
  return {start.position,
          start.position + first_a,
          start.position + 2.0 * first_a + second_a,
          end.position - 2.0 * first_b + second_b,
          end.position - first_b,
          end.position};
}

double secondDerivativeBound(const ControlPoints& points) {
  double squared = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    squared = std::max(squared, (points[k + 2] - 2.0 * points[k + 1] + points[k]).squaredNorm());
  }
  return 20.0 * std::sqrt(squared);
}

NearestPlace::NearestPlace(const Centreline& curve, bool with_radius) : curve_(curve) {
  if (curve.pieces.empty()) throw std::invalid_argument("a centreline without pieces has no nearest place");
  pieces_.reserve(curve.pieces.size());
  for (const Centreline::Piece& of : curve.pieces) {
    const ControlPoints points = controlPoints({of.curve, 0.0}, {of.curve, 1.0}, 1.0);
    Piece piece;
    piece.centre = 0.5 * (points.front() + points.back());
    const Vector3d along = (points.back() - points.front()).normalized();
    piece.reach = piece.fastest = 0.0;
    piece.slowest = std::numeric_limits<double>::infinity();
    for (const Vector3d& point : points) piece.reach = std::max(piece.reach, (point - piece.centre).norm());
    for (std::size_t k = 0; k < 5; ++k) {
      const Vector3d first = 5.0 * (points[k + 1] - points[k]);
      piece.fastest = std::max(piece.fastest, first.norm());
      piece.slowest = std::min(piece.slowest, first.dot(along));
    }
    piece.second = secondDerivativeBound(points);
    piece.radius = with_radius ? of.start_radius : 0.0;
    piece.radius_slope = with_radius ? of.end_radius - of.start_radius : 0.0;
    piece.reach += piece.radius + std::max(0.0, piece.radius_slope);
    pieces_.push_back(piece);
  }
}

// Stationary places are zeros of (point - c)·c' + r' |point - c|, positive where the curve comes nearer.
void NearestPlace::findOn(std::size_t index, const Vector3d& point, double t0, double t1, double tolerance,
                          Found& found) const {
  const Piece& piece = pieces_[index];
  const CurvePiece& curve = curve_.pieces[index].curve;
  struct Approach {
    double value, slope, distance;
  };
  const auto approach = [&](double t) {
    const Vector3d away = point - curve.position(t);
    const Vector3d first = curve.first(t);
    const double far = away.norm(), along = away.dot(first);
    const double cone = far > 0.0 ? piece.radius_slope * along / far : 0.0;
    return Approach{along + piece.radius_slope * far, -first.squaredNorm() + away.dot(curve.second(t)) - cone,
                    far};
  };
  const auto keep = [&](double t, double far) {
    const double distance = far - (piece.radius + t * piece.radius_slope);
    found.lower_bound = std::min(found.lower_bound, distance);
    if (distance < found.distance) {
      found.distance = distance;
      found.place = {index, t};
    }
  };

  const Approach start = approach(t0), end = approach(t1);
  keep(t0, start.distance);
  keep(t1, end.distance);
  const double width = t1 - t0;
  const double furthest = std::max(start.distance, end.distance) + 0.5 * width * piece.fastest;
  const bool one_minimum =
      piece.slowest > 0.0 &&
      piece.slowest * piece.slowest > furthest * piece.second + std::abs(piece.radius_slope) * piece.fastest;
  if (one_minimum) {
    if (start.value <= 0.0 || end.value >= 0.0) return;
    double low = t0, high = t1;
    double t = t0 + width * start.value / (start.value - end.value);
    for (int i = 0; i < 60; ++i) {
      const Approach here = approach(t);
      (here.value > 0.0 ? low : high) = t;
      double next = t - here.value / here.slope;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (std::abs(next - t) < 1e-12 || i == 59) {
        keep(next, (point - curve.position(next)).norm());
        return;
      }
      t = next;
    }
  }
  // the distance from the chord, less how far curve and chord can be apart
  const Vector3d a = curve.position(t0), chord = curve.position(t1) - a;
  const double squared = chord.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((point - a).dot(chord) / squared, 0.0, 1.0) : 0.0;
  const double sagitta = width * width * piece.second / 8.0;
  const double radius = piece.radius + piece.radius_slope * (piece.radius_slope > 0.0 ? t1 : t0);
  const double bound = (point - a - share * chord).norm() - sagitta - radius;
  if (bound >= found.distance - tolerance || width < 1e-12) {
    found.lower_bound = std::min(found.lower_bound, bound);
    return;
  }
  const double middle = 0.5 * (t0 + t1);
  findOn(index, point, t0, middle, tolerance, found);
  findOn(index, point, middle, t1, tolerance, found);
}

NearestPlace::Found NearestPlace::find(const Vector3d& point, const Centreline::Place& guess,
                                       double tolerance) const {
  Found found;
  found.distance = found.lower_bound = distance(point, guess);
  found.place = guess;
  const std::size_t first = guess.piece;
  findOn(first, point, 0.0, 1.0, tolerance, found);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double within = found.distance + pieces_[i].reach;
    if (i == first || within < 0.0 || (point - pieces_[i].centre).squaredNorm() > within * within) continue;
    findOn(i, point, 0.0, 1.0, tolerance, found);
  }
  return found;
}

Centreline::Place NearestPlace::slide(const Vector3d& point, Centreline::Place at) const {
  const auto length = [&](std::size_t i) { return curve_.pieces[i].end - curve_.pieces[i].start; };
  for (int i = 0; i < 12; ++i) {
    const CurvePiece& curve = curve_.pieces[at.piece].curve;
    const Vector3d away = point - curve.position(at.t);
    const Vector3d first = curve.first(at.t);
    const double speed = first.squaredNorm();
    const double value = away.dot(first) + pieces_[at.piece].radius_slope * away.norm();
    const double step = value / std::max(speed - away.dot(curve.second(at.t)), 0.2 * speed);
    double t = at.t + step;
    while (t > 1.0 && at.piece + 1 < pieces_.size()) {
      t = (t - 1.0) * length(at.piece) / length(at.piece + 1);
      ++at.piece;
    }
    while (t < 0.0 && at.piece > 0) {
      t = 1.0 + t * length(at.piece) / length(at.piece - 1);
      --at.piece;
    }
    at.t = std::clamp(t, 0.0, 1.0);
    if (std::abs(step) < 1e-6) break;
  }
  return at;
}

}  // namespace cable_variation
