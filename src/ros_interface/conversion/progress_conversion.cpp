#include <ros_interface/conversion/progress_conversion.h>

#include <cmath>

namespace cable_variation_ros {

using cable_variation::Progress;

namespace {

double remaining(const Progress& progress, double elapsed) {
  const double left = cable_variation::timeLeft(elapsed, progress.share);
  return std::isnan(left) ? -1.0 : left;
}

}  // namespace

void setFeedback(const Progress& progress, double elapsed,
                 cable_variation::GenerateEnvelopeFeedback& feedback) {
  feedback.stage = progress.stage;
  feedback.share = progress.share;
  feedback.solves = static_cast<std::uint32_t>(progress.done);
  feedback.time = progress.time;
  feedback.elapsed = elapsed;
  feedback.remaining = remaining(progress, elapsed);
}

void setFeedback(const Progress& progress, double elapsed,
                 cable_variation::SimulateVariationFeedback& feedback) {
  feedback.samples = progress.done;
  feedback.wanted = progress.wanted;
  feedback.elapsed = elapsed;
  feedback.remaining = remaining(progress, elapsed);
  feedback.snapped = progress.snapped;
  feedback.failed = progress.failed;
  feedback.measures.clear();
  feedback.mean.clear();
  feedback.sigma.clear();
  for (const Progress::Figure& figure : progress.figures) {
    feedback.measures.push_back(figure.measure);
    feedback.mean.push_back(figure.mean);
    feedback.sigma.push_back(figure.sigma);
  }
}

}  // namespace cable_variation_ros
