#include <cable_variation/scene_file/pose_reader.h>

#include <cmath>

namespace cable_variation {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond about(const Vector3d& axis, double angle) { return Quaterniond(Eigen::AngleAxisd(angle, axis)); }

Quaterniond readQuaternion(const YamlCursor& cursor) {
  constexpr double kNormTolerance = 1e-3;  // generous to rounded decimals, not to slips
  std::vector<double> c;
  for (const YamlCursor& item : cursor.items(4)) c.push_back(item.number(quantity::number));
  if (c.size() != 4) return Quaterniond::Identity();
  const Quaterniond q(c[0], c[1], c[2], c[3]);
  if (std::isnan(q.norm())) return Quaterniond::Identity();
  if (std::abs(q.norm() - 1.0) > kNormTolerance) {
    cursor.fail("norm is " + shortNumber(q.norm()) + "; expected a unit quaternion [w, x, y, z]");
    return Quaterniond::Identity();
  }
  return q.normalized();
}

Quaterniond readAxes(const YamlCursor& cursor) {
  const Vector3d x = readDirection(*cursor.find("x_axis"));
  Quaterniond orientation = Quaterniond::Identity();
  if (const auto side = cursor.find("y_axis")) {
    constexpr double kParallel = 1e-6;
    const Vector3d y = readDirection(*side);
    const Vector3d normal = x.cross(y);
    if (normal.norm() < kParallel) {
      side->fail("it is parallel to x_axis; expected a direction to the side");
    } else {
      Eigen::Matrix3d axes;
      axes.col(0) = x;
      axes.col(2) = normal.normalized();
      axes.col(1) = axes.col(2).cross(x);
      orientation = Quaterniond(axes);
    }
  } else {
    const Vector3d axis = Vector3d::UnitX().cross(x);
    const double angle = std::atan2(axis.norm(), x.x());
    orientation = about(axis.norm() > 0.0 ? axis.normalized() : Vector3d(Vector3d::UnitZ()), angle);
  }
  const double roll = cursor.number("roll", quantity::angle, Range::any(), 0.0);
  return std::isnan(roll) ? orientation : orientation * about(Vector3d::UnitX(), roll);
}

}  // namespace

const std::vector<std::string>& orientationKeys() {
  static const std::vector<std::string> keys{"rpy", "quaternion", "x_axis", "y_axis", "roll"};
  return keys;
}

Eigen::Quaterniond readOrientation(const YamlCursor& cursor) {
  const auto rpy = cursor.find("rpy");
  const auto quaternion = cursor.find("quaternion");
  const bool axes = cursor.has("x_axis");
  if ((rpy ? 1 : 0) + (quaternion ? 1 : 0) + (axes ? 1 : 0) > 1) {
    cursor.fail("the orientation is given twice; expected one of rpy, quaternion, x_axis");
    return Quaterniond::Identity();
  }
  if (!axes && (cursor.has("y_axis") || cursor.has("roll"))) cursor.fail("y_axis and roll go with an x_axis");
  if (quaternion) return readQuaternion(*quaternion);
  if (axes) return readAxes(cursor);
  if (!rpy) return Quaterniond::Identity();
  const Vector3d angles = rpy->vector(quantity::angle);
  if (!angles.allFinite()) return Quaterniond::Identity();
  return about(Vector3d::UnitZ(), angles.z()) * about(Vector3d::UnitY(), angles.y()) *
         about(Vector3d::UnitX(), angles.x());
}

Pose readPose(const YamlCursor& cursor) {
  std::vector<std::string> keys = orientationKeys();
  keys.insert(keys.begin(), "position");
  if (!cursor.checkKeys(keys)) return {};
  Pose pose;
  pose.position = cursor.vector("position", quantity::length, Vector3d::Zero());
  pose.orientation = readOrientation(cursor);
  return pose;
}

Eigen::Vector3d readAxisOrDirection(const YamlCursor& cursor) {
  if (cursor.isList()) return readDirection(cursor);
  return Vector3d::Unit(static_cast<int>(cursor.choice({"x", "y", "z"})));
}

Eigen::Vector3d readDirection(const YamlCursor& cursor) {
  const Vector3d direction = cursor.vector(quantity::number);
  if (!direction.allFinite()) return Vector3d::UnitX();
  if (!(direction.norm() > 0.0)) {
    cursor.fail("its length is 0; expected a direction");
    return Vector3d::UnitX();
  }
  return direction.normalized();
}

}  // namespace cable_variation
