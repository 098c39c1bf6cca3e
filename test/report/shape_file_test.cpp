// Solved cables as files for other programs, read back.
#include <cable_variation/report/shape_file/shape_file.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

// Two strands that hang between clamps, the second pulled aside in its middle.
struct Strands {
  Harness harness;
  Equilibrium equilibrium;
  ComponentPoses components;

  Strands() {
    harness = caseW();
    Cable other = uniformCable(0.3, strandOfCaseW(), "other, \"thick\"");
    harness.cables.push_back(other);
    Clip start = clipOn(1, "start", 0.0, fixedClip());
    start.pose = poseAt(0.0, 0.2, 0.0);
    Clip end = clipOn(1, "end", 0.3, fixedClip());
    end.pose = poseAt(0.25, 0.2, 0.0);
    harness.clips.push_back(start);
    harness.clips.push_back(end);
    harness.loads.push_back(loadAt(1, 0.15, {0.0, 2.0, 0.0}));
    equilibrium = solve(harness);
    EXPECT_TRUE(equilibrium.converged()) << equilibrium.message;
  }
  SolvedScene solved() const { return {harness, equilibrium, components}; }
};

using Row = std::vector<double>;  // from the second column on

std::map<std::string, std::vector<Row>> readCsv(const std::string& text) {
  std::map<std::string, std::vector<Row>> rows;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const std::size_t quote = line.rfind('"');
    std::istringstream values(line.substr(quote + 2));
    Row row;
    for (std::string value; std::getline(values, value, ',');) row.push_back(std::stod(value));
    rows[line.substr(0, quote + 1)].push_back(row);
  }
  return rows;
}

Vector3d vectorAt(const Row& row, std::size_t at) { return {row[at], row[at + 1], row[at + 2]}; }

TEST(shape_file, csv_has_the_shape_and_what_acts_in_it) {
  const Strands strands;
  const auto rows = readCsv(shapeCsv(strands.solved(), {0, 1}, 2e-3));
  ASSERT_EQ(rows.size(), 2U);
  const std::vector<Row>& of = rows.at("\"other, \"\"thick\"\"\"");
  const CableShape& shape = strands.equilibrium.shapes[1];
  ASSERT_GE(of.size(), 151U);
  EXPECT_EQ(of.front()[0], 0.0);
  EXPECT_EQ(of.back()[0], 0.3);
  Vector3d jump = Vector3d::Zero();
  for (std::size_t i = 0; i < of.size(); ++i) {
    ASSERT_EQ(of[i].size(), 16U);
    EXPECT_LT((vectorAt(of[i], 1) - shape.position(of[i][0])).norm(), 1e-12);
    const Eigen::Quaterniond turned(of[i][4], of[i][5], of[i][6], of[i][7]);
    EXPECT_LT(turned.angularDistance(shape.pose(of[i][0]).orientation), 1e-9);
    EXPECT_EQ(of[i][15], 0.004);
    if (i == 0) continue;
    const double step = of[i][0] - of[i - 1][0];
    EXPECT_LE(step, 2e-3 + 1e-12);
    if (step > 0.0) {
      // the balance of force: weight is all that acts between
      const Vector3d change = vectorAt(of[i], 8) - vectorAt(of[i - 1], 8);
      const double weight = 2000.0 * M_PI * 0.004 * 0.004 * step * 9.81;
      const double known =
          2e-5 * vectorAt(of[i], 8).norm();  // sections are turned to that between grid points
      EXPECT_LT((change - Vector3d(0.0, 0.0, weight)).norm(), known) << of[i][0];
    } else {
      jump += vectorAt(of[i], 8) - vectorAt(of[i - 1], 8);
    }
  }
  EXPECT_LT((jump + Vector3d(0.0, 2.0, 0.0)).norm(), 1e-6);  // the load
  // at the ends the clips' reactions: of the part s+ on the part s-
  EXPECT_LT((vectorAt(of.front(), 8) + strands.equilibrium.clip_reactions[2].force).norm(), 1e-6);
  EXPECT_LT((vectorAt(of.back(), 8) - strands.equilibrium.clip_reactions[3].force).norm(), 1e-6);
}

// Between the sections solved it is not known what presses.
TEST(shape_file, forces_of_a_cable_that_touches_are_those_at_solved_sections) {
  Strands strands;
  strands.equilibrium.contacts.emplace_back();
  strands.equilibrium.contacts.back().cable = 1;
  const auto rows = readCsv(shapeCsv(strands.solved(), {0, 1}, 1e-3));
  std::size_t known = 0, unknown = 0;
  for (const Row& row : rows.at("\"other, \"\"thick\"\"\"")) {
    const auto& points = strands.equilibrium.shapes[1].points;
    const bool solved = std::any_of(points.begin(), points.end(), [&](const ShapePoint& point) {
      return std::abs(point.arc_length - row[0]) < 1e-12;
    });
    EXPECT_EQ(std::isnan(row[8]), !solved) << row[0];
    EXPECT_FALSE(std::isnan(row[1]));
    (solved ? known : unknown) += 1;
  }
  EXPECT_GT(known, 5U);
  EXPECT_GT(unknown, known);
  for (const auto& [cable, of] : rows) {
    if (cable.find("other") != std::string::npos) continue;
    for (const Row& row : of) EXPECT_FALSE(std::isnan(row[8]));
  }
}

TEST(shape_file, vtk_has_a_line_per_cable_and_as_many_values_as_points) {
  const Strands strands;
  std::istringstream file(shapeVtk(strands.solved(), {1, 0}, 5e-3));
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "# vtk DataFile Version 3.0");
  std::getline(file, line);
  std::string word, type;
  std::size_t count = 0, lines = 0, size = 0;
  file >> word;
  EXPECT_EQ(word, "ASCII");
  file >> word >> type;
  EXPECT_EQ(type, "POLYDATA");
  file >> word >> count >> type;
  ASSERT_EQ(word, "POINTS");
  std::vector<Vector3d> points(count);
  for (Vector3d& point : points) file >> point.x() >> point.y() >> point.z();
  file >> word >> lines >> size;
  ASSERT_EQ(word, "LINES");
  ASSERT_EQ(lines, 2U);
  EXPECT_EQ(size, count + 2);
  std::size_t expected = 0;
  for (std::size_t k = 0; k < lines; ++k) {
    std::size_t of = 0;
    file >> of;
    for (std::size_t i = 0, index = 0; i < of; ++i) {
      file >> index;
      EXPECT_EQ(index, expected++);
    }
    const CableShape& shape = strands.equilibrium.shapes[k == 0 ? 1 : 0];
    EXPECT_LT((points[expected - of] - shape.points.front().pose.position).norm(), 1e-15);
    EXPECT_LT((points[expected - 1] - shape.points.back().pose.position).norm(), 1e-15);
  }
  EXPECT_EQ(expected, count);
  std::map<std::string, std::size_t> values;
  const auto field = [&](const std::string& of) {  // its number of arrays
    std::size_t arrays = 0;
    file >> word >> size >> word >> word >> arrays;
    EXPECT_EQ(word, "FieldData") << of;
    return arrays;
  };
  std::string name;
  EXPECT_EQ(field("cells"), 1U);
  file >> name >> size >> size >> type;
  std::vector<int> cells(lines);
  for (int& cell : cells) file >> cell;
  EXPECT_EQ(cells, (std::vector<int>{1, 0}));
  const std::size_t arrays = field("points");
  for (std::size_t k = 0; k < arrays; ++k) {
    std::size_t components = 0, rows = 0;
    file >> name >> components >> rows >> type;
    EXPECT_EQ(rows, count) << name;
    double value = 0.0;
    while (values[name] < components * rows && file >> value) ++values[name];
    EXPECT_EQ(values[name], components * count) << name;
  }
  EXPECT_EQ(values["force"], 3 * count);
  EXPECT_FALSE(file >> word) << word;
  EXPECT_EQ(values.size(), 6U);
}

TEST(shape_file, dxf_has_a_polyline_in_millimetres_per_cable) {
  const Strands strands;
  std::istringstream file(shapeDxf(strands.solved(), {0, 1}, 5e-3));
  std::vector<std::pair<int, std::string>> groups;
  for (std::string code, value; std::getline(file, code) && std::getline(file, value);)
    groups.emplace_back(std::stoi(code), value);
  std::map<std::string, std::vector<Vector3d>> polylines;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i] != std::pair<int, std::string>{0, "VERTEX"}) continue;
    ASSERT_EQ(groups[i + 1].first, 8);
    Vector3d at;
    for (int k = 0; k < 3; ++k) at[k] = std::stod(groups[i + 2 + k].second);
    polylines[groups[i + 1].second].push_back(at);
  }
  EXPECT_EQ(groups.back(), (std::pair<int, std::string>{0, "EOF"}));
  ASSERT_EQ(polylines.size(), 2U);
  ASSERT_EQ(polylines.count("OTHER___THICK_"), 1U);
  double length = 0.0;
  const std::vector<Vector3d>& other = polylines["OTHER___THICK_"];
  for (std::size_t i = 1; i < other.size(); ++i) {
    const double step = (other[i] - other[i - 1]).norm();
    EXPECT_GT(step, 0.0);
    length += step;
  }
  const std::vector<Pose> fine = strands.equilibrium.shapes[1].sample(5001);
  double expected = 0.0;  // compressed a little between its clips
  for (std::size_t i = 1; i < fine.size(); ++i)
    expected += 1e3 * (fine[i].position - fine[i - 1].position).norm();
  EXPECT_NEAR(length, expected, 0.05);
  EXPECT_LT((other.back() - 1e3 * Vector3d(0.25, 0.2, 0.0)).norm(), 1e-9);
}

// Closed, and of a prism's volume within the round one's.
TEST(shape_file, stl_is_the_closed_surface) {
  const Strands strands;
  const std::string file = shapeStl(strands.solved(), {1}, 1e-3);
  std::uint32_t count = 0;
  std::memcpy(&count, file.data() + 80, sizeof(count));
  ASSERT_EQ(file.size(), 84U + 50U * count);
  double volume = 0.0;
  Vector3d area = Vector3d::Zero();
  for (std::uint32_t i = 0; i < count; ++i) {
    float numbers[12];
    std::memcpy(numbers, file.data() + 84 + 50 * i, sizeof(numbers));
    const auto corner = [&](int k) {
      return Vector3d(numbers[3 * k + 3], numbers[3 * k + 4], numbers[3 * k + 5]);
    };
    volume += corner(0).cross(corner(1)).dot(corner(2)) / 6.0;
    area += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0));
  }
  const double round = M_PI * 0.004 * 0.004 * 0.3;
  EXPECT_LT(volume, round);
  EXPECT_GT(volume, 0.98 * round);
  EXPECT_LT(area.norm(), 1e-9);
}

TEST(shape_file, steps_that_are_none_are_refused) {
  const Strands strands;
  for (const double step : {0.0, -1e-3, std::nan(""), 1e-9}) {
    EXPECT_THROW(shapeCsv(strands.solved(), {1}, step), std::invalid_argument) << step;
    EXPECT_THROW(shapeStl(strands.solved(), {1}, step), std::invalid_argument) << step;
  }
}

}  // namespace
}  // namespace cable_variation::test
