// What is read of a KBL file, and what is said of broken ones: the id, the line, what was expected.
#include <cable_variation/import/kbl_document.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "kbl_texts.h"

namespace cable_variation {
namespace {

KblDocument smallDocument() { return readKblText(smallKbl(), "small.kbl"); }

TEST(KblDocument, lengthsAreInMetresAndIdsAreKept) {
  const KblDocument document = smallDocument();
  EXPECT_EQ(document.version, "2.4 SR-1");
  EXPECT_EQ(document.part_number, "HARNESS-1");
  ASSERT_EQ(document.segments.size(), 4U);
  const KblSegment& segment = document.segments[0];
  EXPECT_EQ(segment.id, "Segment_1");
  EXPECT_EQ(segment.name, "route 1");
  EXPECT_NEAR(segment.virtual_length.value(), 0.2, 1e-12);
  EXPECT_NEAR(segment.diameter().value(), 0.008, 1e-9);
  EXPECT_EQ(document.nodes[segment.start_node].id, "Node_1");
  EXPECT_EQ(document.nodes[segment.end_node].id, "Node_2");
  EXPECT_EQ(segment.curves.size(), 2U);
  EXPECT_NEAR(document.nodes[2].position.x(), 0.5, 1e-12);
  ASSERT_EQ(document.segments[1].fixings.size(), 1U);
  EXPECT_EQ(document.occurrences[document.segments[1].fixings[0].occurrence].id, "Fixing_occurrence_1");
}

TEST(KblDocument, placementsAreAxesUAndV) {
  const KblDocument document = smallDocument();
  for (const KblOccurrence& part : document.occurrences) {
    if (part.id != "Connector_2") continue;
    ASSERT_TRUE(part.placement);
    EXPECT_LT((part.placement->orientation * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(),
              1e-12);
    EXPECT_LT((part.placement->orientation * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitX()).norm(),
              1e-12);
    EXPECT_EQ(part.part_number, "H-200");
    return;
  }
  FAIL() << "there is no Connector_2";
}

TEST(KblDocument, coresAreTheirWire) {
  const KblDocument document = smallDocument();
  ASSERT_EQ(document.wires.size(), 4U);
  EXPECT_EQ(document.routings[3].wire, document.routings[4].wire);
  const KblWirePart& multicore = document.wire_parts[document.wires[document.routings[3].wire].part];
  EXPECT_NEAR(multicore.conductor_area.value(), 2e-6, 1e-15);
  EXPECT_NEAR(multicore.mass_per_length.value(), 0.03, 1e-12);
}

// Each fault: what is changed, and what must be said.
struct Fault {
  std::string place, by;
  std::vector<std::string> said;
};

TEST(KblDocument, brokenFilesAreToldWithIdAndExpectation) {
  const std::vector<Fault> faults{
      {"<Start_node>Node_1</Start_node>",
       "<Start_node>Node_77</Start_node>",
       {"Segment 'Segment_1', Start_node", "'Node_77'", "expected that of a Node"}},
      {"<Start_node>Node_1</Start_node>",
       "<Start_node>Unit_mm</Start_node>",
       {"Segment_1", "'Unit_mm' is the id of a Unit", "Node"}},
      {"<Start_node>Node_1</Start_node>", "", {"Segment 'Segment_1'", "'Start_node' is missing"}},
      {"<Start_node>Node_1</Start_node>",
       "<Start_node>Node_2</Start_node>",
       {"Segment 'Segment_1'", "from node 'Node_2' to itself"}},
      {"<Coordinates>80</Coordinates>",
       "<Coordinates>eighty</Coordinates>",
       {"Cartesian_point '", "'eighty'", "expected a number"}},
      {"<Coordinates>80</Coordinates>", "", {"Cartesian_point '", "2 times", "expected 3 numbers"}},
      {"<Value_component>200.000000</Value_component>",
       "<Value_component>-200</Value_component>",
       {"Segment_1", "-200", "expected between"}},
      {"<Virtual_length id=\"Virtual_length_1\"><Unit_component>Unit_mm<",
       "<Virtual_length id=\"Virtual_length_1\"><Unit_component>Unit_g<",
       {"Segment 'Segment_1', Virtual_length/Unit_component", "'gram'", "a length"}},
      {"<Area id=\"Area_1\"><Unit_component>Unit_mm2<",
       "<Area id=\"Area_1\"><Unit_component>Unit_mm<",
       {"Segment 'Segment_1', Cross_section_area_information/Area/Unit_component", "an area"}},
      {"<Degree>3</Degree>", "<Degree>9</Degree>", {"Segment_1", "4 control points", "at least 10"}},
      {"<Degree>3</Degree>", "<Degree>2.5</Degree>", {"Segment_1", "2.5", "whole number"}},
      {"<Location>0.5</Location>", "<Location>1.5</Location>", {"Segment_2", "1.5", "0 to 1"}},
      {"<Fixing>Fixing_occurrence_1</Fixing>",
       "<Fixing>Fixing_1</Fixing>",
       {"Segment_2", "'Fixing_1' is the id of a Fixing", "Fixing_occurrence"}},
      {"<Routed_wire>Connection_1</Routed_wire>",
       "<Routed_wire>Connection_9</Routed_wire>",
       {"Routing 'Routing_1'", "'Connection_9'"}},
      {"<Segments>Segment_1 Segment_2</Segments>",
       "<Segments>Segment_1 Segment_8</Segments>",
       {"Routing 'Routing_1'", "'Segment_8'"}},
      {"<Node id=\"Node_2\">", "<Node id=\"Node_1\">", {"the id 'Node_1'", "too", "expected another one"}},
      {"<U>1</U><U>0</U><U>0</U><V>0</V><V>1</V>",
       "<U>1</U><U>0</U><U>0</U><V>1</V><V>0</V>",
       {"Connector_occurrence 'Connector_1'", "right angles"}},
      {"</Harness>", "", {"the file is no XML"}},
      {"KBL_container xmlns", "Vec_container xmlns", {"the file is no XML"}},
  };
  for (const Fault& fault : faults) {
    const std::string said = faultOf(with(smallKbl(), fault.place, fault.by));
    EXPECT_EQ(said.compare(0, 9, "file.kbl:"), 0) << said;
    for (const std::string& part : fault.said)
      EXPECT_NE(said.find(part), std::string::npos) << "no '" << part << "' in: " << said;
  }
}

TEST(KblDocument, linesAreThoseOfTheFile) {
  const std::string text =
      with(smallKbl(), "<Start_node>Node_1</Start_node>", "<Start_node>Node_77</Start_node>");
  const std::size_t line =
      1 + static_cast<std::size_t>(std::count(
              text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("Node_77")), '\n'));
  EXPECT_EQ(faultOf(text).find("file.kbl:" + std::to_string(line) + ": "), 0U) << faultOf(text);
}

TEST(KblDocument, allFaultsAreToldAtOnce) {
  std::string text = with(smallKbl(), "<Start_node>Node_1</Start_node>", "<Start_node>Node_77</Start_node>");
  text = with(text, "<Location>0.5</Location>", "<Location>1.5</Location>");
  const std::string said = faultOf(text);
  EXPECT_NE(said.find("Node_77"), std::string::npos);
  EXPECT_NE(said.find("1.5"), std::string::npos);
}

TEST(KblDocument, otherFilesAreRefused) {
  EXPECT_NE(faultOf("").find("no XML"), std::string::npos);
  EXPECT_NE(faultOf("<a/>").find("expected a KBL_container"), std::string::npos);
  EXPECT_NE(faultOf("<KBL_container/>").find("there is no Segment"), std::string::npos);
  try {
    readKbl("/nowhere/at/all.kbl");
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/at/all.kbl: the file does not exist"),
              std::string::npos)
        << error.what();
  }
}

TEST(KblDocument, hostileFilesAreRefusedAtOnce) {
  std::string deep = "<KBL_container>";
  for (int i = 0; i < 200000; ++i) deep += "<a>";
  for (int i = 0; i < 200000; ++i) deep += "</a>";
  EXPECT_NE(faultOf(deep + "</KBL_container>").find("there is no Segment"), std::string::npos);
  std::string large = "<KBL_container>";
  for (int i = 0; i < 1100000; ++i) large += "<a/><b/>";
  EXPECT_NE(faultOf(large + "</KBL_container>").find("the limit xml_parts"), std::string::npos);
  // entities are not followed
  const std::string text = with(smallKbl(), "<Coordinates>80<", "<Coordinates>&many;<");
  EXPECT_NE(faultOf(text).find("'&many;'"), std::string::npos) << faultOf(text);
}

TEST(KblDocument, aMassInAnotherUnitIsAFinding) {
  const std::string mass = "<Mass_information id=\"Mass_1\"><Unit_component>";
  const KblDocument document =
      readKblText(with(smallKbl(), mass + "Unit_g_per_m", mass + "Unit_g"), "file.kbl");
  ASSERT_EQ(document.findings.size(), 1U);
  EXPECT_EQ(document.findings[0].kind, ImportFinding::Kind::wrong_unit);
  EXPECT_EQ(document.findings[0].id, "Wire_1");
  EXPECT_FALSE(document.wire_parts[0].mass_per_length);
}

}  // namespace
}  // namespace cable_variation
