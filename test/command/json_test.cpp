// JSON as it is written.
#include <command/json.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace cable_variation_command {
namespace {

TEST(JsonText, NumbersAreReadBackAsTheSameAndWhatIsNoneIsNotOne) {
  EXPECT_EQ(Json(0.1).text(), "0.1\n");
  EXPECT_EQ(std::stod(Json(1.0 / 3.0).text()), 1.0 / 3.0);
  EXPECT_EQ(Json(-0.0).text(), "-0\n");
  EXPECT_EQ(Json(std::nan("")).text(), "null\n");
  EXPECT_EQ(Json(std::numeric_limits<double>::infinity()).text(), "\"infinite\"\n");
  EXPECT_EQ(Json(-std::numeric_limits<double>::infinity()).text(), "\"-infinite\"\n");
  EXPECT_EQ(Json(std::numeric_limits<std::uint64_t>::max()).text(), "18446744073709551615\n");
  EXPECT_EQ(Json(true).text(), "true\n");
}

TEST(JsonText, TextsAreQuotedAndAlwaysUtf8) {
  EXPECT_EQ(Json("a \"b\" \\ \n").text(), "\"a \\\"b\\\" \\\\ \\u000a\"\n");
  EXPECT_EQ(Json("Kabel ä").text(), "\"Kabel ä\"\n");
  EXPECT_EQ(Json(std::string("a\xff") + "b").text(),
            "\"a\xEF\xBF\xBD"
            "b\"\n");
}

TEST(JsonText, ObjectsKeepTheirOrder) {
  Json json = Json::object();
  json.set("b", 1).set("a", std::vector<double>{1.0, 2.5}).set("c", Json::array());
  EXPECT_EQ(json.text(), "{\n  \"b\": 1,\n  \"a\": [1, 2.5],\n  \"c\": []\n}\n");
  Json more = Json::object();
  more.set("first", "x").append(json);
  EXPECT_EQ(more.text(), "{\n  \"first\": \"x\",\n  \"b\": 1,\n  \"a\": [1, 2.5],\n  \"c\": []\n}\n");
}

TEST(JsonText, MatricesAreRowByRow) {
  Eigen::MatrixXd matrix(2, 2);
  matrix << 1, 2, 3, 4;
  EXPECT_EQ(rowByRow(matrix).text(), "[1, 2, 3, 4]\n");
}

}  // namespace
}  // namespace cable_variation_command
