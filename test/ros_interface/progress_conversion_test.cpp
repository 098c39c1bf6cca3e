// Progress as feedback of the actions.
#include <ros_interface/conversion/progress_conversion.h>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

using cable_variation::Progress;

TEST(ProgressConversion, OfAnEnvelope) {
  cable_variation::GenerateEnvelopeFeedback feedback;
  setFeedback({"containment", 0.75, 120, 1.5}, 6.0, feedback);
  EXPECT_EQ(feedback.stage, "containment");
  EXPECT_EQ(feedback.share, 0.75);
  EXPECT_EQ(feedback.solves, 120U);
  EXPECT_EQ(feedback.time, 1.5);
  EXPECT_EQ(feedback.elapsed, 6.0);
  EXPECT_DOUBLE_EQ(feedback.remaining, 2.0);
  setFeedback({}, 6.0, feedback);
  EXPECT_EQ(feedback.remaining, -1.0);  // none yet
}

TEST(ProgressConversion, OfASimulation) {
  Progress progress;
  progress.share = 0.2;
  progress.done = 2000;
  progress.wanted = 10000;
  progress.snapped = 3;
  progress.failed = 1;
  progress.figures = {{"gap", 0.01, 0.001}, {"bend", 0.06, 0.002}};
  cable_variation::SimulateVariationFeedback feedback;
  for (int again = 0; again < 2; ++again) {  // nothing is left of what was told before
    setFeedback(progress, 1.0, feedback);
    EXPECT_EQ(feedback.samples, 2000U);
    EXPECT_EQ(feedback.wanted, 10000U);
    EXPECT_EQ(feedback.snapped, 3U);
    EXPECT_EQ(feedback.failed, 1U);
    EXPECT_DOUBLE_EQ(feedback.remaining, 4.0);
    EXPECT_EQ(feedback.measures, (std::vector<std::string>{"gap", "bend"}));
    EXPECT_EQ(feedback.mean, (std::vector<double>{0.01, 0.06}));
    EXPECT_EQ(feedback.sigma, (std::vector<double>{0.001, 0.002}));
  }
}

}  // namespace
}  // namespace cable_variation_ros
