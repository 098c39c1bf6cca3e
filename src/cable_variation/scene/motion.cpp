#include <cable_variation/scene/motion.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>
#include <stdexcept>

#include <cable_variation/scene/motion_samples.h>
#include <cable_variation/scene/resource_address.h>
#include <cable_variation/util/readable_text.h>
#include <cable_variation/util/regular_file.h>

namespace cable_variation {
namespace {

constexpr std::uintmax_t kMostBytes = 1'000'000'000;

TimedPose readLine(const std::string& line) {
  constexpr double kNormTolerance = 1e-3;
  std::istringstream words(line);
  words.imbue(std::locale::classic());
  double value[8];
  for (double& number : value) {
    std::string word;
    if (!(words >> word))
      throw std::invalid_argument("a number is missing; expected time tx ty tz qx qy qz qw");
    std::istringstream stream(word);
    stream.imbue(std::locale::classic());
    if (!(stream >> number) || !stream.eof() || !std::isfinite(number)) {
      if (word.find(',') != std::string::npos) {
        throw std::invalid_argument(
            "found '" + readableText(word) +
            "'; expected numbers parted by blanks, with a decimal point and no comma");
      }
      throw std::invalid_argument("found '" + readableText(word) + "'; expected a finite number");
    }
  }
  std::string rest;
  if (words >> rest)
    throw std::invalid_argument("found '" + readableText(rest) +
                                "' after the eighth number; expected no more");

  TimedPose sample;
  sample.time = value[0];
  sample.pose.position = {value[1], value[2], value[3]};
  const Eigen::Quaterniond q(value[7], value[4], value[5], value[6]);
  if (std::abs(q.norm() - 1.0) > kNormTolerance) {
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

void readTum(const std::string& path, Motion& motion) {
  const std::string mark = "\xef\xbb\xbf";  // of UTF-8
  const std::string obstacle = obstacleTo(path, kMostBytes);
  if (!obstacle.empty()) throw std::invalid_argument(path + ": " + obstacle);
  std::ifstream file(path);
  MotionSamples samples;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (number == 1 && line.compare(0, mark.size(), mark) == 0) line.erase(0, mark.size());
    if (number == 1 && (line.compare(0, 2, "\xff\xfe") == 0 || line.compare(0, 2, "\xfe\xff") == 0))
      throw std::invalid_argument(path + ":1: the file is in UTF-16; expected UTF-8");
    line.erase(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      const TimedPose sample = readLine(line);
      samples.add(sample.time, sample.pose);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(path + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  if (file.bad()) throw std::invalid_argument(path + ": cannot be read");
  try {
    samples.finish(motion);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace cable_variation
