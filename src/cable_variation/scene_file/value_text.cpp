#include <cable_variation/scene_file/value_text.h>

#include <cmath>

#include <cable_variation/util/number_text.h>
#include <cable_variation/util/unit.h>

namespace cable_variation {
namespace {

constexpr int kDigits = 12;
constexpr double kDegree = M_PI / 180.0;

std::string rounded(double value, double step, const char* unit) {
  const double whole = std::round(value / step);
  return whole == 0.0 ? "0" : numberText(whole * step, kDigits) + unit;
}

std::string listText(const Eigen::Vector3d& values, double factor, double step, const char* unit) {
  std::string text = "[";
  for (int i = 0; i < 3; ++i) text += (i > 0 ? ", " : "") + rounded(factor * values[i], step, unit);
  return text + "]";
}

// Angles about the fixed axes x, y, z in this order; where only the sum of two is certain, the last one is
// what it is and the first one fits it.
Eigen::Vector3d rollPitchYaw(const Eigen::Quaterniond& orientation) {
  const Eigen::Matrix3d r = orientation.toRotationMatrix();
  const double yaw = std::atan2(r(1, 0), r(0, 0));
  const double c = std::cos(yaw), s = std::sin(yaw);
  const double pitch = std::atan2(-r(2, 0), c * r(0, 0) + s * r(1, 0));
  const double roll = std::atan2(s * r(0, 2) - c * r(1, 2), c * r(1, 1) - s * r(0, 1));
  return {roll, pitch, yaw};
}

}  // namespace

std::string valueLike(const std::string& text, double value, const Quantity& quantity) {
  const bool quoted = text.size() > 1 && (text.front() == '"' || text.front() == '\'');
  const std::string bare = quoted ? text.substr(1, text.size() - 2) : text;
  const QuantityText before = readQuantity(bare, quantity);
  double number = 0.0;
  const std::string plain = plainSigns(bare);
  const std::size_t begin = plain.find_first_not_of(" \t+");
  const auto end = readNumber(std::string_view(plain).substr(begin), number).ptr;
  const std::string unit(end, plain.data() + plain.size());
  const double factor = before.has_unit ? parseUnit(unit.substr(unit.find_first_not_of(" \t"))).factor : 1.0;
  const std::string written = numberText(value / factor, kDigits) + (before.has_unit ? unit : "");
  return quoted ? text.front() + written + text.back() : written;
}

std::string lengthText(double metres) { return numberText(1e3 * metres, kDigits) + " mm"; }

std::string positionText(const Eigen::Vector3d& position) { return listText(position, 1e3, 1e-6, " mm"); }

std::string rotationText(const Eigen::Quaterniond& orientation) {
  return "rpy: " + listText(rollPitchYaw(orientation), 1.0 / kDegree, 1e-8, " deg");
}

std::string poseText(const Pose& pose) {
  const std::string rotation = rotationText(pose.orientation);
  return "{position: " + positionText(pose.position) + (rotation == "rpy: [0, 0, 0]" ? "" : ", " + rotation) +
         "}";
}

}  // namespace cable_variation
