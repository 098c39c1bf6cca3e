// A motion in a bag, which another program reads for us: poses, or a message.
#include <cable_variation/scene/motion.h>
#include <ros_interface/conversion/bag_motion.h>

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cable_variation;
  // what the other program hands over, whatever has become of it
  acceptsOrRefuses([&] {
    Motion motion;
    cable_variation_ros::setPoses(textOf(data, size), motion);
    if (cable_variation_ros::bytesOf(motion) != textOf(data, size)) throw std::logic_error("poses are lost");
  });
  const MemoryFile file(data, size);
  // it has nothing open that we have
  const std::string path =
      "/proc/" + std::to_string(getpid()) + file.path().substr(std::string("/proc/self").size());
  return acceptsOrRefuses([&] {
    Motion motion;
    cable_variation_ros::readBagMotion(path, "", "sled", "world", motion);
    if (!poseAt(motion, motion.duration()).position.allFinite())
      throw std::logic_error("a pose is not finite");
  });
}
