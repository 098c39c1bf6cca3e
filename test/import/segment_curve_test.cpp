// Centre curves: clamped or not, in pieces, reversed; stale ones are told and not used.
#include <cable_variation/import/segment_curve.h>

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "kbl_texts.h"

namespace cable_variation {
namespace {

using Kind = ImportFinding::Kind;

std::vector<std::optional<SegmentCurve>> curvesOf(const std::string& text, ImportFindings& findings) {
  return soundCurves(readKblText(text, "file.kbl"), findings);
}

// The one finding of a text.
ImportFinding findingOf(const std::string& text) {
  ImportFindings findings;
  curvesOf(text, findings);
  EXPECT_EQ(findings.size(), 1U);
  return findings.empty() ? ImportFinding() : findings.front();
}

TEST(SegmentCurve, lengthsAreThoseOfTheirClosedForms) {
  ImportFindings findings;
  const auto curves = curvesOf(smallKbl(), findings);
  EXPECT_TRUE(findings.empty());
  ASSERT_EQ(curves.size(), 4U);
  // the second one is z = q u (u - 1) over 300 mm, in two unclamped pieces, rounded to 1e-6 mm
  const double q = 0.06, span = 0.3, slope = q / span;
  const double parabola = 0.5 * span * (std::sqrt(1 + slope * slope) + std::asinh(slope) / slope);
  EXPECT_NEAR(curves[0]->length(), 0.2, 1e-8);
  EXPECT_NEAR(curves[1]->length(), parabola, 1e-8);
  EXPECT_NEAR(curves[2]->length(), 0.15, 1e-8);  // clamped
}

TEST(SegmentCurve, placesAreByArcLength) {
  ImportFindings findings;
  const auto curves = curvesOf(smallKbl(), findings);
  const SegmentCurve& curve = *curves[1];
  const CurvePoint middle = curve.at(0.5 * curve.length());
  EXPECT_LT((middle.position - Eigen::Vector3d(0.35, 0.0, -0.015)).norm(), 1e-8);
  EXPECT_LT((middle.tangent - Eigen::Vector3d::UnitX()).norm(), 1e-7);
  for (const CurvePoint& sample : curve.samples()) {
    const CurvePoint again = curve.at(sample.arc_length);
    EXPECT_LT((again.position - sample.position).norm(), 1e-8);
    EXPECT_LT((again.tangent - sample.tangent).norm(), 1e-7);
  }
  EXPECT_LT((curve.at(-1.0).position - Eigen::Vector3d(0.2, 0.0, 0.0)).norm(), 1e-8);
  EXPECT_LT((curve.at(9.0).position - Eigen::Vector3d(0.5, 0.0, 0.0)).norm(), 1e-8);
}

TEST(SegmentCurve, oneFromEndToStartIsReadSo) {
  const std::string text =
      with(smallKbl(), "<End_node>Node_2</End_node>\n    <Start_node>Node_4</Start_node>",
           "<End_node>Node_4</End_node>\n    <Start_node>Node_2</Start_node>");
  const ImportFinding finding = findingOf(text);
  EXPECT_EQ(finding.kind, Kind::reversed_curve);
  EXPECT_EQ(finding.id, "Segment_3");
  ImportFindings findings;
  const auto curves = curvesOf(text, findings);
  EXPECT_LT((curves[2]->at(0.0).position - Eigen::Vector3d(0.2, 0.0, 0.0)).norm(), 1e-8);
  EXPECT_LT((curves[2]->at(0.01).tangent - Eigen::Vector3d::UnitY()).norm(), 1e-8);
}

TEST(SegmentCurve, staleOnesAreToldWithBothLengthsAndNotUsed) {
  const ImportFinding finding = findingOf(with(smallKbl(), ">200.000000<", ">201.500000<"));
  EXPECT_EQ(finding.kind, Kind::stale_curve);
  EXPECT_EQ(finding.id, "Segment_1");
  EXPECT_GT(finding.line, 0);
  EXPECT_NE(finding.message.find("is 200 mm long, and Virtual_length says 201.5 mm"), std::string::npos)
      << finding.message;
  ImportFindings findings;
  EXPECT_FALSE(curvesOf(with(smallKbl(), ">200.000000<", ">201.500000<"), findings)[0]);
}

TEST(SegmentCurve, endsElsewhereAreToldWithTheNode) {
  // node 5 is moved by 3 mm; its segment's curve stays
  const std::string point = "Cartesian_point_29\"><Coordinates>200</Coordinates><Coordinates>";
  const std::string text = with(smallKbl(), point + "-80", point + "-83");
  const ImportFinding finding = findingOf(text);
  EXPECT_EQ(finding.kind, Kind::stale_curve);
  EXPECT_EQ(finding.id, "Segment_4");
  EXPECT_NE(finding.message.find("3 mm from node 'Node_5'"), std::string::npos) << finding.message;
}

TEST(SegmentCurve, gapsBetweenPiecesAreTold) {
  // the second piece's control points begin at 80 mm, the first one's end there
  const std::string text =
      with(smallKbl(), "Cartesian_point_5 Cartesian_point_6", "Cartesian_point_6 Cartesian_point_6");
  const ImportFinding finding = findingOf(text);
  EXPECT_EQ(finding.kind, Kind::open_curve);
  EXPECT_EQ(finding.id, "Segment_1");
}

TEST(SegmentCurve, aSegmentNeedsALength) {
  std::string text = smallKbl();
  const std::size_t begin = text.find("<Virtual_length id=\"Virtual_length_1\">");
  text.erase(begin, text.find("</Virtual_length>", begin) + 17 - begin);
  ImportFindings findings;
  const KblDocument document = readKblText(text, "file.kbl");
  auto curves = soundCurves(document, findings);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, Kind::no_length);
  EXPECT_NEAR(segmentLengths(document, curves, LengthSource::virtual_length)[0], 0.2, 1e-8);
  curves[0].reset();
  try {
    segmentLengths(document, curves, LengthSource::virtual_length);
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("Segment 'Segment_1': there is neither Virtual_length"),
              std::string::npos)
        << error.what();
  }
}

TEST(SegmentCurve, coordinatesInMetresAreTold) {
  KblDocument document = readKblText(smallKbl(), "file.kbl");
  for (KblNode& node : document.nodes) node.position *= 1e-3;
  ImportFindings findings;
  const auto curves = soundCurves(document, findings);
  try {
    segmentLengths(document, curves, LengthSource::virtual_length);
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("are the coordinates in mm?"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace cable_variation
