#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/math/pose.h>

namespace cable_variation_command {

/// A value to be written as JSON (RFC 8259), in UTF-8. Numbers are read back as the same doubles; what is not
/// a number is null, and what is infinite the text "infinite" or "-infinite", for JSON has neither.
class Json {
 public:
  static Json object() { return Json(Kind::object); }
  static Json array() { return Json(Kind::array); }

  Json(bool value);
  Json(double value);
  Json(const char* value);
  Json(const std::string& value);
  template <typename Integer, std::enable_if_t<std::is_integral_v<Integer>, int> = 0>
  Json(Integer value) : text_(std::to_string(value)) {}
  template <typename Value>
  Json(const std::vector<Value>& values) : kind_(Kind::array) {
    for (const auto& value : values) add(Json(Value(value)));
  }
  Json(const Eigen::Vector3d& vector);      ///< {x, y, z}
  Json(const Eigen::VectorXd& vector);      ///< a list
  Json(const cable_variation::Pose& pose);  ///< {position, orientation: {x, y, z, w}}, as in messages

  /// A member more of an object, in the order they are set.
  Json& set(const std::string& name, Json value);
  /// All members of another object.
  Json& append(const Json& object);
  /// An element more of an array.
  Json& add(Json value);

  /// With line breaks, and one at its end.
  std::string text() const;

 private:
  enum class Kind { scalar, array, object };
  explicit Json(Kind kind) : kind_(kind) {}
  void write(std::string& to, std::size_t depth) const;
  bool holdsScalars() const;

  Kind kind_ = Kind::scalar;
  std::string text_;
  std::vector<std::pair<std::string, Json>> members_;  // of an array without names
};

/// Row by row, as in messages.
Json rowByRow(const Eigen::MatrixXd& matrix);

}  // namespace cable_variation_command
