#include <cable_variation/scene/motion.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <cable_variation/scene/motion_samples.h>
#include <cable_variation/scene/resource_address.h>
#include <cable_variation/scene/tum_file.h>
#include <cable_variation/util/data_lines.h>
#include <cable_variation/util/readable_text.h>
#include <cable_variation/util/text_tokens.h>

namespace cable_variation {
namespace {

TimedPose readLine(const std::string& line) {
  constexpr double kNormTolerance = 1e-3;
  TextTokens words(line);
  double value[8];
  for (double& number : value) {
    const auto word = words.nextInLine();
    if (!word) throw std::invalid_argument("a number is missing; expected time tx ty tz qx qy qz qw");
    const auto read = numberIn(*word);
    if (!read) {
      const std::string found = readableText(std::string(*word));
      if (found.find(',') != std::string::npos) {
        throw std::invalid_argument(
            "found '" + found + "'; expected numbers parted by blanks, with a decimal point and no comma");
      }
      throw std::invalid_argument("found '" + found + "'; expected a finite number");
    }
    number = *read;
  }
  if (const auto rest = words.nextInLine()) {
    throw std::invalid_argument("found '" + readableText(std::string(*rest)) +
                                "' after the eighth number; expected no more");
  }

  TimedPose sample;
  sample.time = value[0];
  sample.pose.position = {value[1], value[2], value[3]};
  const Eigen::Quaterniond q(value[7], value[4], value[5], value[6]);
  if (!(std::abs(q.norm() - 1.0) <= kNormTolerance)) {
    throw std::invalid_argument("quaternion has norm " + std::to_string(q.norm()) + "; expected 1");
  }
  sample.pose.orientation = q.normalized();
  return sample;
}

}  // namespace

Pose poseAt(const Motion& motion, double time) {
  const std::vector<TimedPose>& samples = motion.samples;
  if (samples.empty()) throw std::invalid_argument("motion '" + motion.name + "' is not loaded");
  if (std::isnan(time)) throw std::invalid_argument("time of motion '" + motion.name + "' is not a number");
  const auto after = std::upper_bound(samples.begin(), samples.end(), time,
                                      [](double t, const TimedPose& sample) { return t < sample.time; });
  if (after == samples.begin()) return samples.front().pose;
  if (after == samples.end()) return samples.back().pose;
  const TimedPose& a = *(after - 1);
  const TimedPose& b = *after;
  const double t = (time - a.time) / (b.time - a.time);
  return {a.pose.position + t * (b.pose.position - a.pose.position),
          a.pose.orientation.slerp(t, b.pose.orientation)};
}

bool isBag(const std::string& file) { return extensionOf(file) == ".bag"; }

void readTum(const std::string& path, Motion& motion) { readTum(path, motion, InputLimits()); }

void readTum(const std::string& path, Motion& motion, const InputLimits& limits) {
  MotionSamples samples;
  readDataLines(path, limits.motion_bytes, [&](const std::string& line) {
    const TimedPose sample = readLine(line);
    samples.add(sample.time, sample.pose);
    if (samples.size() > limits.poses) {
      throw std::invalid_argument("the file has more poses; " + atMost(limits.poses, "poses"));
    }
  });
  try {
    samples.finish(motion);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace cable_variation
