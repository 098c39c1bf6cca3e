// The chapter on cables of a made-up simulation: where they vary most, in units a person reads.
#include <cable_variation/report/cable_variation_section.h>

#include <gtest/gtest.h>

#include <cable_variation/report/page.h>
#include <report/well_formed.h>

namespace cable_variation {
namespace {

class CableVariationSection : public testing::Test {
 protected:
  // One cable of 0.4 m: 6σ of 3 mm in its middle, along z; a range of 5 mm next to it.
  CableVariationSection() {
    scene_.harness.cables.resize(1);
    scene_.harness.cables[0].name = "ma<in>";
    CableVariation cable;
    cable.arc_length = {0.0, 0.1, 0.2, 0.3, 0.4};
    cable.sections.resize(5);
    cable.sections[2].axes.sigma[0] = 0.0005;
    cable.sections[2].axes.directions.col(0) = Eigen::Vector3d::UnitZ();
    cable.sections[2].mean = {0.125, -0.25, 0.5};
    cable.sections[2].range = {0.0, 0.004, 0.0};
    cable.sections[3].range = {0.005, 0.0, 0.0};
    simulation_.cables = {cable};
    simulation_.times = {{0.0, 0.003, 7}};
    simulation_.statistics.outcomes = {10, 0, 0, 0};
  }

  std::string html() const { return cableVariationSection(scene_, simulation_).html(); }

  Scene scene_;
  Simulation simulation_;
};

TEST_F(CableVariationSection, SaysWhereACableVariesMost) {
  EXPECT_EQ(faultOfXml(reportPage("A harness", {}, {}, {cableVariationSection(scene_, simulation_)})), "");
  for (const char* text : {"ma&lt;in&gt;", "<td>3</td>", "<td>4</td>", "<td>200</td>", "125, −250, 500",
                           "0, 0, 1", "<svg", ">5</text>", ">400</text>"}) {
    EXPECT_NE(html().find(text), std::string::npos) << text << " in " << html();
  }
  EXPECT_EQ(html().find("motion"), std::string::npos);
}

TEST_F(CableVariationSection, TimesOfAMotionAreToldToo) {
  simulation_.times = {{1.5, 0.002, 4}, {31.25, 0.003, 6}};
  simulation_.shown_time = 31.25;
  for (const char* text : {"31.25 s, where the cables vary most", "1.5"}) {
    EXPECT_NE(html().find(text), std::string::npos) << text;
  }
}

TEST_F(CableVariationSection, WithoutShapesNothingIsDrawn) {
  simulation_.statistics.outcomes = {1, 0, 9, 0};
  EXPECT_EQ(html().find("<svg"), std::string::npos);
  EXPECT_NE(html().find("Fewer than two samples"), std::string::npos);
}

}  // namespace
}  // namespace cable_variation
