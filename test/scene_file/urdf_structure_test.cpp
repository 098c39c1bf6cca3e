// URDFs that a parser could fall into: a fault in a moment, or read as they are.
#include <cable_variation/scene_file/urdf_structure.h>

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/geometry/mesh/mesh_reader.h>
#include <cable_variation/scene/resource_address.h>
#include <cable_variation/scene_file/urdf_reader.h>

#include "test_packages.h"

#include "cpu_time.h"

namespace cable_variation {
namespace {

using Faults = std::vector<std::string>;

const std::string kBox = "<visual><geometry><box size=\"0.1 0.1 0.1\"/></geometry></visual>";

LoadedMesh load(const std::string& address, const Eigen::Vector3d& scale) {
  const ResourceFile file = findResource(address, findTestPackage);
  return {std::make_shared<TriangleMesh>(readMesh(file.path, scale)), file.url};
}

struct Reading {
  std::vector<Visual> visuals;
  Faults faults;
  Faults warnings;
};

Reading read(const std::string& text, const std::map<std::string, JointPosition>& positions = {}) {
  const TemporaryFile file("structure.urdf", {text});
  Reading reading;
  const test::CpuTime start;
  testing::internal::CaptureStderr();
  reading.visuals = readUrdf(file.path(), positions, load, reading.faults, reading.warnings);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_LT(start.seconds(), 10.0);
  return reading;
}

std::string robot(const std::string& content) { return "<robot name=\"r\">" + content + "</robot>"; }
std::string link(const std::string& name, const std::string& content = "") {
  return "<link name=\"" + name + "\">" + content + "</link>";
}
std::string joint(const std::string& name, const std::string& parent, const std::string& child) {
  return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" +
         child + "\"/></joint>\n";
}

TEST(UrdfStructure, twoParents) {
  const std::string links = link("l0", kBox) + link("a") + link("b") + "\n";
  EXPECT_EQ(
      read(robot(links + joint("j0", "l0", "a") + joint("j1", "a", "b") + joint("j2", "b", "a"))).faults,
      Faults{"link 'a' has two parents, 'l0' by joint 'j0' and 'b' by joint 'j2' (line 4)"});
  EXPECT_EQ(
      read(robot(links + joint("j0", "l0", "a") + joint("j1", "l0", "a") + joint("j2", "a", "b"))).faults,
      Faults{"link 'a' has two parents, 'l0' by joint 'j0' and 'l0' by joint 'j1' (line 3)"});
}

// Diamonds one below the other: 2^n ways from the root to the end.
TEST(UrdfStructure, diamonds) {
  for (const int count : {2, 40, 2000}) {
    std::string content = link("l0", kBox);
    for (int i = 1; i < count; ++i) {
      const std::string above = "l" + std::to_string(i - 1), here = "l" + std::to_string(i);
      content += link(here) + joint("a" + here, above, here) + joint("b" + here, above, here);
    }
    const Faults faults = read(robot(content)).faults;
    EXPECT_EQ(faults.size(), static_cast<std::size_t>(std::min(count - 1, 101)));
    if (count == 2000) {
      EXPECT_EQ(faults.back(), "and 1899 more faults of its links and joints");
    }
  }
}

TEST(UrdfStructure, cyclesAndRoots) {
  EXPECT_EQ(read(robot(link("a", kBox) + joint("j", "a", "a"))).faults,
            Faults{"links are their own parents: a -> a"});
  EXPECT_EQ(read(robot(link("r", kBox) + link("a") + link("b") + joint("j", "a", "b") + joint("k", "b", "a")))
                .faults,
            Faults{"links are their own parents: a -> b -> a"});
  EXPECT_EQ(read(robot(link("a", kBox) + link("b", kBox) + link("c") + joint("j", "a", "c"))).faults,
            Faults{"2 links have no parent: a, b; expected one"});
  EXPECT_EQ(read(robot("")).faults, Faults{"it has no links"});
}

TEST(UrdfStructure, namesThatAreNotThere) {
  EXPECT_EQ(read(robot(link("base", kBox) + joint("j", "base", "tip"))).faults,
            Faults{"joint 'j': there is no link 'tip'; known: base (line 1)"});
  EXPECT_EQ(read(robot(link("base", kBox) + link("base"))).faults,
            Faults{"there are two links 'base' (line 1)"});
  EXPECT_EQ(read(robot(link("base", kBox) + "<link/>")).faults, Faults{"a link has no name (line 1)"});
  EXPECT_EQ(read(robot(link("base", kBox) + link("tip") + "<joint name=\"j\" type=\"fixed\"/>")).faults,
            (Faults{"joint 'j' names no parent link (line 1)", "joint 'j' names no child link (line 1)"}));
}

TEST(UrdfStructure, whatIsNoXml) {
  EXPECT_EQ(read("hello").faults, Faults{"it is no XML (line 1)"});
  EXPECT_EQ(read("<a/>").faults, Faults{"it is no URDF; expected an element <robot>"});
  EXPECT_EQ(read("\n<robot><link name=\"a\"></robot>").faults, Faults{"it is no XML (line 2)"});
  EXPECT_EQ(read("").faults.size(), 1U);
  EXPECT_EQ(read("<!DOCTYPE a [<!ENTITY x \"y\">]>" + robot(link("a", kBox))).faults, Faults());
}

TEST(UrdfStructure, nestingHasAnEnd) {
  for (const std::string open : {"<a>", "<link name=\"a\">", "<a b='/>'>"}) {
    std::string text = "<robot name=\"r\">";
    for (int i = 0; i < 100000; ++i) text += open;
    ASSERT_EQ(read(text).faults.size(), 1U);
    EXPECT_NE(read(text).faults[0].find("its elements are nested too deep"), std::string::npos);
  }
}

// As many elements or attributes as a parser would take all memory for.
TEST(UrdfStructure, theNumberOfElementsHasAnEnd) {
  std::string elements, attributes = "<robot";
  for (int i = 0; i < 1200000; ++i) {
    elements += "<a/>";
    attributes += " b=''";
  }
  EXPECT_EQ(read(robot(elements)).faults.size(), 1U);
  const std::string said = read(robot(elements + elements)).faults.at(0);
  EXPECT_NE(said.find("expected at most 2000000 (the limit xml_parts)"), std::string::npos) << said;
  EXPECT_NE(read(attributes + attributes).faults.at(0).find("xml_parts"), std::string::npos);
}

// A fault for each of many joints, each with names to be looked through, is told in no time.
TEST(UrdfStructure, manyFaultsTakeNoTime) {
  std::string content;
  for (int i = 0; i < 30000; ++i) content += link("a_link_of_a_long_name_" + std::to_string(i));
  for (int i = 0; i < 30000; ++i) content += joint("j" + std::to_string(i), "a_link_of_a_long_nome", "none");
  const test::CpuTime start;
  EXPECT_EQ(read(robot(content)).faults.size(), 101U);
  EXPECT_LT(start.seconds(), 5.0);
}

// However long a chain is, and in whatever order its links and joints are listed: its poses add up.
TEST(UrdfStructure, aLongChain) {
  std::mt19937 random(5);
  for (const std::size_t count : {10U, 50000U}) {
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    std::string content;
    for (const std::size_t i : order) {
      content += link("l" + std::to_string(i), i + 1 == count ? kBox : "");
      if (i == 0) continue;
      content += "<joint name=\"j" + std::to_string(i) + "\" type=\"fixed\"><parent link=\"l" +
                 std::to_string(i - 1) + "\"/><child link=\"l" + std::to_string(i) +
                 "\"/><origin xyz=\"0.001 0 0\"/></joint>";
    }
    const Reading reading = read(robot(content));
    EXPECT_EQ(reading.faults, Faults());
    ASSERT_EQ(reading.visuals.size(), 1U);
    EXPECT_NEAR(reading.visuals[0].pose.position.x(), 0.001 * static_cast<double>(count - 1), 1e-8);
    // and when it is refused
    EXPECT_EQ(read(robot(content + link("other"))).faults.size(), 1U);
  }
}

// Signs of format strings, wherever they stand, are letters like others.
TEST(UrdfStructure, percentSignsAreLetters) {
  const std::string evil = "%s%n%s%n%s%x%d%100000d%.9999f";
  std::string escaped;  // the same by references to characters
  for (const char c : evil) escaped += c == '%' ? "&#37;" : c == 's' ? "&#x73;" : std::string(1, c);
  for (const std::string& name : {evil, escaped, std::string("&#x25;s&#x0025;n")}) {
    const std::string plain = name.find("x25") != std::string::npos ? "%s%n" : evil;
    // a material that is named and not defined
    EXPECT_EQ(read(robot("<material name=\"" + name + "\"/>" + link("a", kBox))).visuals.size() +
                  read(robot("<material name=\"" + name + "\"/>" + link("a", kBox))).faults.size(),
              1U);
    // names of links and joints
    const Reading named = read(robot(link("base") + link(name, kBox) + joint(name, "base", name)));
    EXPECT_EQ(named.faults, Faults());
    ASSERT_EQ(named.visuals.size(), 1U);
    EXPECT_EQ(named.visuals[0].name, plain);
    // in numbers, types, colours and addresses
    const Reading position =
        read(robot(link("base") + link("tip", kBox) + "<joint name=\"j\" type=\"" + name +
                   "\"><parent link=\"base\"/><child link=\"tip\"/>"
                   "<origin xyz=\"" +
                   name + " 0 0\"/></joint>"));
    ASSERT_FALSE(position.faults.empty());
    EXPECT_NE(position.faults[0].find(plain), std::string::npos) << position.faults[0];
    const Reading colour =
        read(robot("<material name=\"m\"><color rgba=\"" + name + "\"/></material>" + link("a", kBox)));
    EXPECT_FALSE(colour.faults.empty());
    const Reading mesh = read(robot(link("a", "<visual><geometry><mesh filename=\"package://test_data/" +
                                                  name + ".stl\"/></geometry></visual>")));
    ASSERT_EQ(mesh.faults.size(), 1U);
    EXPECT_NE(mesh.faults[0].find(plain), std::string::npos) << mesh.faults[0];
  }
}

TEST(UrdfStructure, jointsWithPercentSignsAreSetByName) {
  const std::string text = robot(link("base") + link("tip", kBox) +
                                 "<joint name=\"50%\" type=\"prismatic\"><parent link=\"base\"/><child "
                                 "link=\"tip\"/><axis xyz=\"1 0 0\"/>"
                                 "<limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>");
  const Reading reading = read(text, {{"50%", {0.25, JointPosition::Unit::metre}}});
  EXPECT_EQ(reading.faults, Faults());
  ASSERT_EQ(reading.visuals.size(), 1U);
  EXPECT_DOUBLE_EQ(reading.visuals[0].pose.position.x(), 0.25);
}

TEST(UrdfStructure, anAngleInDegreesIsWarnedOf) {
  const std::string text = robot(link("base") + link("tip", kBox) +
                                 "<joint name=\"j\" type=\"continuous\"><parent link=\"base\"/><child "
                                 "link=\"tip\"/><axis xyz=\"0 0 1\"/></joint>");
  EXPECT_EQ(read(text, {{"j", {90.0, JointPosition::Unit::none}}}).warnings,
            Faults{"joint 'j' is at 90 without a unit, in rad; in deg?"});
  EXPECT_EQ(read(text, {{"j", {90.0, JointPosition::Unit::radian}}}).warnings, Faults());
  EXPECT_EQ(read(text, {{"j", {1.5, JointPosition::Unit::none}}}).warnings, Faults());
}

}  // namespace
}  // namespace cable_variation
