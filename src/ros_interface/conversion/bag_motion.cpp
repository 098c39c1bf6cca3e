#include <ros_interface/conversion/bag_motion.h>

#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

#include <cable_variation/util/import_program.h>

namespace cable_variation_ros {

using cable_variation::InputLimits;
using cable_variation::Motion;
using cable_variation::TimedPose;

namespace {

using Row = std::array<double, 8>;  // time [s], position [m], quaternion w, x, y, z

constexpr std::size_t kCount = sizeof(std::uint64_t);  // bytes before them: how many poses were replaced

Row rowOf(const TimedPose& sample) {
  const Eigen::Vector3d& p = sample.pose.position;
  const Eigen::Quaterniond& q = sample.pose.orientation;
  return {sample.time, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
}

TimedPose sampleOf(const Row& row) {
  TimedPose sample;
  sample.time = row[0];
  sample.pose.position = {row[1], row[2], row[3]};
  sample.pose.orientation = Eigen::Quaterniond(row[4], row[5], row[6], row[7]);
  return sample;
}

void require(bool sound, const char* what) {
  if (!sound) throw std::invalid_argument(std::string("its importer handed over ") + what);
}

}  // namespace

std::string bytesOf(const Motion& motion) {
  const std::uint64_t replaced = motion.replaced_poses;
  std::string bytes(reinterpret_cast<const char*>(&replaced), kCount);
  bytes.reserve(kCount + motion.samples.size() * sizeof(Row));
  for (const TimedPose& sample : motion.samples) {
    const Row row = rowOf(sample);
    bytes.append(reinterpret_cast<const char*>(row.data()), sizeof(Row));
  }
  return bytes;
}

void setPoses(const std::string& bytes, Motion& motion) {
  require(bytes.size() > kCount && (bytes.size() - kCount) % sizeof(Row) == 0, "no poses");
  std::uint64_t replaced = 0;
  std::memcpy(&replaced, bytes.data(), kCount);
  std::vector<TimedPose> samples;
  samples.reserve((bytes.size() - kCount) / sizeof(Row));
  for (std::size_t at = kCount; at < bytes.size(); at += sizeof(Row)) {
    Row row{};
    std::memcpy(row.data(), bytes.data() + at, sizeof(Row));
    for (const double number : row) require(std::isfinite(number), "a pose that is not finite");
    const TimedPose sample = sampleOf(row);
    require(std::abs(sample.pose.orientation.norm() - 1.0) < 1e-3, "a quaternion that is no rotation");
    require(samples.empty() ? sample.time == 0.0 : sample.time > samples.back().time,
            "times that do not increase from 0");
    samples.push_back(sample);
  }
  motion.samples = std::move(samples);
  motion.replaced_poses = replaced;
}

void readBagMotion(const std::string& path, const std::string& topic, const std::string& frame,
                   const std::string& parent, Motion& motion, const InputLimits& limits) {
  try {
    setPoses(
        cable_variation::imported("bag_importer", {path, topic, frame, parent}, "", limits,
                                  kCount + limits.poses * sizeof(Row),
                                  "it has more poses; " + cable_variation::atMost(limits.poses, "poses")),
        motion);
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what(), who = "bag '" + path + "'";
    throw std::invalid_argument(message.compare(0, who.size(), who) == 0 ? message : who + ": " + message);
  }
}

}  // namespace cable_variation_ros
