#include <cable_variation/report/shape_file/cable_points.h>

#include <cmath>
#include <stdexcept>

#include <cable_variation/measures/section_loads.h>
#include <cable_variation/report/cable_profile.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

namespace {

constexpr double kMostPoints = 1e6;

}  // namespace

void checkStep(const Cable& cable, double step) {
  if (!(step > 0.0)) {
    throw std::invalid_argument("step " + shortNumber(step) + " m: expected more than 0 m");
  }
  if (!(cable.length / step <= kMostPoints)) {
    throw std::invalid_argument("step " + shortNumber(step) + " m: cable '" + cable.name + "' of " +
                                shortNumber(cable.length) + " m would have more than a million points");
  }
}

std::vector<CablePoint> cablePoints(const SolvedScene& solved, std::size_t cable, double step) {
  const Cable& of = solved.harness.cables[cable];
  checkStep(of, step);
  const CableShape& shape = solved.equilibrium.shapes[cable];
  const CableView view(of, shape);
  const bool touches = touchesPart(solved.equilibrium, cable);
  std::vector<CablePoint> points;
  for (std::size_t i = 0; i < view.pieces().size(); ++i) {
    const CableView::Piece& piece = view.pieces()[i];
    const SectionLoads loads(view, i, solved.harness.gravity);
    const CurvePiece curve = curveBetween(view.start(i), view.end(i));
    const bool after_jump = i == 0 || view.pieces()[i - 1].point + 1 != piece.point;
    const int parts = std::max(1, static_cast<int>(std::ceil(piece.length / step)));
    for (int k = after_jump ? 0 : 1; k <= parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      CablePoint point;
      point.arc_length = view.start(i).arc_length + t * piece.length;
      point.pose = k == 0       ? view.start(i).pose
                   : k == parts ? view.end(i).pose
                                : Pose{curve.position(t), shape.pose(point.arc_length).orientation};
      point.radius = view.line().radius({i, t});
      point.curvature = curve.curvature(t);
      if (!touches || k == 0 || k == parts) {
        point.force = point.pose.orientation * loads.force(t);
        point.moment = point.pose.orientation * loads.moment(t);
      }
      points.push_back(point);
    }
  }
  return points;
}

}  // namespace cable_variation
