#include <cable_variation/identification/shape_residuals.h>

#include <Eigen/Geometry>

#include <cable_variation/geometry/tube_distance/nearest_place.h>
#include <cable_variation/measures/cable_view.h>

namespace cable_variation {

namespace {

constexpr double kTolerance = 1e-9;  // of the distance of the first point [m]

/// The place on the centreline that belongs to each point.
std::vector<Place> placesOf(const CableView& view, const std::vector<Eigen::Vector3d>& points) {
  const NearestPlace nearest(view.line(), false);
  std::vector<Place> places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 0) {
      places.push_back(nearest.find(points[0], {0, 0.0}, kTolerance).place);
    } else {
      const double further = view.arcLength(places.back()) + (points[i] - points[i - 1]).norm();
      places.push_back(nearest.slide(points[i], view.at(further)));
    }
  }
  return places;
}

/// Columns: two directions normal to the curve and its own.
Eigen::Matrix3d axesAt(const CableView& view, const Place& place) {
  Eigen::Matrix3d axes;
  axes.col(2) = view.line().pieces[place.piece].curve.first(place.t).normalized();
  axes.col(0) = axes.col(2).unitOrthogonal();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

}  // namespace

ShapeResiduals shapeResiduals(const Harness& harness, const Equilibrium& equilibrium,
                              const MeasuredShape& measured, const std::vector<EquilibriumRate>& rates) {
  const CableView view(harness.cables[measured.cable], equilibrium.shapes[measured.cable]);
  const std::vector<Place> places = placesOf(view, measured.points);
  const auto rows = static_cast<Eigen::Index>(3 * places.size());
  ShapeResiduals residuals;
  residuals.values.setZero(rows);
  residuals.rates.setZero(rows, static_cast<Eigen::Index>(rates.size()));
  const CableRate none;  // positions do not ask what becomes of the section
  for (std::size_t i = 0; i < places.size(); ++i) {
    // Where the place is no end it slides along with the point.
    const Eigen::Index directions = view.isEnd(places[i]) ? 3 : 2;
    const Eigen::Matrix3d axes = axesAt(view, places[i]);
    const auto row = static_cast<Eigen::Index>(3 * i);
    const Eigen::Vector3d gap = axes.transpose() * (measured.points[i] - view.line().position(places[i]));
    residuals.values.segment(row, directions) = gap.head(directions);
    for (std::size_t k = 0; k < rates.size(); ++k) {
      const CableRates of{rates[k].shapes[measured.cable], none};
      const Eigen::Vector3d moved = axes.transpose() * view.rate(places[i], of).position;
      residuals.rates.col(static_cast<Eigen::Index>(k)).segment(row, directions) = -moved.head(directions);
    }
  }
  return residuals;
}

}  // namespace cable_variation
