#include <command/json.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/util/number_text.h>
#include <cable_variation/util/utf8.h>

namespace cable_variation_command {

namespace {

std::string quoted(const std::string& text) {
  constexpr char kDigits[] = "0123456789abcdef";
  constexpr char kNoCharacter[] = "\xEF\xBF\xBD";  // U+FFFD
  std::string result = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const std::size_t length = cable_variation::utf8Length(text, at);
    if (byte == '"' || byte == '\\') {
      result += {'\\', text[at]};
    } else if (byte < 0x20) {
      result += std::string("\\u00") + kDigits[byte >> 4U] + kDigits[byte & 0xfU];
    } else if (length > 0) {
      result.append(text, at, length);
    } else {
      result += kNoCharacter;
    }
    at += std::max<std::size_t>(length, 1);
  }
  return result + '"';
}

}  // namespace

Json::Json(bool value) : text_(value ? "true" : "false") {}
Json::Json(double value)
    : text_(std::isnan(value)   ? "null"
            : std::isinf(value) ? (value > 0.0 ? "\"infinite\"" : "\"-infinite\"")
                                : cable_variation::numberText(value)) {}
Json::Json(const char* value) : text_(quoted(value)) {}
Json::Json(const std::string& value) : text_(quoted(value)) {}

Json::Json(const Eigen::Vector3d& vector) : kind_(Kind::object) {
  set("x", vector.x()).set("y", vector.y()).set("z", vector.z());
}

Json::Json(const Eigen::VectorXd& vector) : kind_(Kind::array) {
  for (Eigen::Index i = 0; i < vector.size(); ++i) add(vector[i]);
}

Json::Json(const cable_variation::Pose& pose) : kind_(Kind::object) {
  const Eigen::Quaterniond& turn = pose.orientation;
  Json orientation = object();
  orientation.set("x", turn.x()).set("y", turn.y()).set("z", turn.z()).set("w", turn.w());
  set("position", pose.position).set("orientation", std::move(orientation));
}

Json& Json::set(const std::string& name, Json value) {
  members_.emplace_back(name, std::move(value));
  return *this;
}

Json& Json::append(const Json& object) {
  members_.insert(members_.end(), object.members_.begin(), object.members_.end());
  return *this;
}

Json& Json::add(Json value) {
  members_.emplace_back("", std::move(value));
  return *this;
}

bool Json::holdsScalars() const {
  return std::all_of(members_.begin(), members_.end(),
                     [](const auto& member) { return member.second.kind_ == Kind::scalar; });
}

void Json::write(std::string& to, std::size_t depth) const {
  if (kind_ == Kind::scalar) {
    to += text_;
    return;
  }
  const bool list = kind_ == Kind::array, in_line = holdsScalars() && (list || depth > 1);
  const std::string between = in_line ? " " : "\n" + std::string(2 * (depth + 1), ' ');
  to += list ? "[" : "{";
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (i > 0) to += ",";
    if (i > 0 || !in_line) to += between;
    if (!list) to += quoted(members_[i].first) + ": ";
    members_[i].second.write(to, depth + 1);
  }
  if (!in_line) to += "\n" + std::string(2 * depth, ' ');
  to += list ? "]" : "}";
}

std::string Json::text() const {
  std::string result;
  write(result, 0);
  return result + "\n";
}

Json rowByRow(const Eigen::MatrixXd& matrix) {
  Json values = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) values.add(matrix(i, j));
  }
  return values;
}

}  // namespace cable_variation_command
