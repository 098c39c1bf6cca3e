#include <cable_variation/geometry/body/convex_hull.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <cable_variation/geometry/body/hull_facets.h>
#include <cable_variation/geometry/mesh/mesh_volume.h>

namespace cable_variation {
namespace {

constexpr double kThinnest = 1e-8;  // of a body, of its extent
constexpr double kAside = 1e-6;     // of vertices that give points a body [m]
constexpr double kAsideShare = 1e-7;
constexpr double kSliver = 1e-8;   // height of a triangle that is no more than its edges, of its longest one
constexpr double kProven = 1e-13;  // gap between a distance and its lower bound, of what it is made from

std::size_t furthest(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& from) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if ((points[i] - from).squaredNorm() > (points[at] - from).squaredNorm()) at = i;
  }
  return at;
}

// What must be added to points for their hull to have a volume.
std::vector<Eigen::Vector3d> bodyFor(const std::vector<Eigen::Vector3d>& points) {
  const Eigen::Vector3d& first = points[furthest(points, points.front())];
  const Eigen::Vector3d along = points[furthest(points, first)] - first;
  const double extent = along.norm();
  const double aside = std::max(kAside, kAsideShare * extent);
  if (extent == 0.0) {
    return {first + aside * Eigen::Vector3d::UnitX(), first + aside * Eigen::Vector3d::UnitY(),
            first + aside * Eigen::Vector3d::UnitZ()};
  }

  const Eigen::Vector3d direction = along / extent;
  Eigen::Vector3d across = Eigen::Vector3d::Zero(), middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d offset = point - first;
    const Eigen::Vector3d off_line = offset - offset.dot(direction) * direction;
    if (off_line.squaredNorm() > across.squaredNorm()) across = off_line;
    middle += offset;
  }
  middle = first + middle / static_cast<double>(points.size());
  if (across.norm() < kThinnest * extent) {
    const Eigen::Vector3d a = aside * someNormal(direction), b = direction.cross(a);
    const Eigen::Vector3d half_way = first + 0.5 * along;
    return {half_way + a, half_way - a, half_way + b, half_way - b};
  }

  const Eigen::Vector3d normal = direction.cross(across).normalized();
  double low = 0.0, high = 0.0;
  for (const Eigen::Vector3d& point : points) {
    const double height = normal.dot(point - first);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  if (high - low >= kThinnest * extent) return {};
  return {middle + aside * normal, middle - aside * normal};
}

}  // namespace

ConvexHull::ConvexHull(const std::vector<Eigen::Vector3d>& points) {
  checkHullPoints(points);
  std::vector<Eigen::Vector3d> all = points;
  const std::vector<Eigen::Vector3d> added = bodyFor(points);
  all.insert(all.end(), added.begin(), added.end());

  auto data = std::make_shared<Data>();
  HullFacets facets = hullFacets(all);
  for (auto* counted : {&facets.triangles, &facets.neighbours}) counted->shrink_to_fit();  // many are kept
  data->sources = std::move(facets.vertices);
  data->neighbours = std::move(facets.neighbours);
  data->surface.triangles = std::move(facets.triangles);
  data->surface.vertices.reserve(data->sources.size());
  for (std::size_t& source : data->sources) {
    data->surface.vertices.push_back(all[source]);
    if (source >= points.size()) source = kAdded;
  }
  data->planes.resize(4, static_cast<Eigen::Index>(data->surface.triangles.size()));
  for (std::size_t i = 0; i < data->surface.triangles.size(); ++i) {
    double offset = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t corner : data->surface.triangles[i]) {
      offset = std::max(offset, facets.normals[i].dot(data->surface.vertices[corner]));
    }
    data->planes.col(static_cast<Eigen::Index>(i)) << facets.normals[i], offset;
  }
  data_ = std::move(data);
}

double ConvexHull::height(const Eigen::Vector3d& point) const {
  return (point.x() * data_->planes.row(0).array() + point.y() * data_->planes.row(1).array() +
          point.z() * data_->planes.row(2).array() - data_->planes.row(3).array())
      .maxCoeff();
}

NearestPoint ConvexHull::nearestOn(std::size_t triangle, const Eigen::Vector3d& point) const {
  SurfaceTriangle face;
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    face.corners[i] = data_->surface.vertices[data_->surface.triangles[triangle][i]];
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, (face.corners[(i + 1) % 3] - face.corners[i]).squaredNorm());
  }
  // The facet's normal as a whole is surer than that of one of its triangles.
  face.normal = data_->planes.col(static_cast<Eigen::Index>(triangle)).head<3>();
  const double area = (face.corners[1] - face.corners[0]).cross(face.corners[2] - face.corners[0]).norm();
  if (area <= kSliver * longest) face.normal.setZero();
  return nearestPoint(face, point);
}

NearestPoint ConvexHull::descend(const Eigen::Vector3d& point, std::size_t& at) const {
  NearestPoint nearest = nearestOn(at, point);
  const auto improve = [&](std::size_t triangle) {
    const NearestPoint other = nearestOn(triangle, point);
    if (other.distance >= nearest.distance) return false;
    nearest = other;
    at = triangle;
    return true;
  };
  for (bool nearer = true; nearer && nearest.on != NearestPoint::On::face;) {
    nearer = false;
    if (nearest.on == NearestPoint::On::edge) {
      nearer = improve(data_->neighbours[at][nearest.number]);
      continue;
    }
    const std::size_t begin = at;
    const std::uint32_t corner = data_->surface.triangles[at][nearest.number];
    std::size_t triangle = data_->neighbours[at][nearest.number];
    while (triangle != begin && !nearer) {
      nearer = improve(triangle);
      const auto& corners = data_->surface.triangles[triangle];
      const auto place = std::find(corners.begin(), corners.end(), corner) - corners.begin();
      triangle = data_->neighbours[triangle][static_cast<std::size_t>(place)];
    }
  }
  return nearest;
}

NearestPoint ConvexHull::nearestOfAll(const Eigen::Vector3d& point, std::size_t& at) const {
  NearestPoint nearest = nearestOn(at, point);
  for (std::size_t i = 0; i < data_->surface.triangles.size(); ++i) {
    const auto plane = data_->planes.col(static_cast<Eigen::Index>(i));
    if (std::abs(plane.head<3>().dot(point) - plane[3]) >= nearest.distance) continue;
    const NearestPoint other = nearestOn(i, point);
    if (other.distance < nearest.distance) {
      nearest = other;
      at = i;
    }
  }
  return nearest;
}

ConvexHull::Closest ConvexHull::closest(const Eigen::Vector3d& point) const {
  Eigen::Index highest = 0;
  const double top = (point.x() * data_->planes.row(0).array() + point.y() * data_->planes.row(1).array() +
                      point.z() * data_->planes.row(2).array() - data_->planes.row(3).array())
                         .maxCoeff(&highest);
  Closest closest;
  closest.triangle = static_cast<std::size_t>(highest);
  NearestPoint nearest;
  if (top <= 0.0) {
    nearest = nearestOn(closest.triangle, point);
    if (nearest.on != NearestPoint::On::face) nearest = nearestOfAll(point, closest.triangle);
    closest.distance = -nearest.distance;
  } else {
    const std::size_t first = closest.triangle;
    nearest = descend(point, closest.triangle);
    if (nearest.on != NearestPoint::On::face || closest.triangle != first) {
      // No point of the hull is nearer than its support in the direction of the point found. On facets that
      // rounding has dented the walk can end early: that shows here.
      double support = -std::numeric_limits<double>::infinity();
      for (const Eigen::Vector3d& vertex : data_->surface.vertices) {
        support = std::max(support, nearest.direction.dot(vertex - nearest.point));
      }
      if (support > kProven * (nearest.distance + point.cwiseAbs().maxCoeff())) {
        nearest = nearestOfAll(point, closest.triangle);
      }
    }
    closest.distance = nearest.distance;
  }
  closest.point = nearest.point;
  return closest;
}

double ConvexHull::volume() const { return volumeWithin(data_->surface); }

}  // namespace cable_variation
