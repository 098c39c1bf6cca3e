// bag_importer MEMORY SECONDS PATH TOPIC FRAME PARENT: reads a component's poses from a rosbag and writes
// them (bag_motion.h), or what is wrong with it, to standard output. A process of its own, because rosbag
// crashes on some files and takes all memory on others (import_program.h).

#include <cable_variation/util/import_program.h>
#include <ros_interface/conversion/bag_motion.h>
#include <ros_interface/conversion/bag_recording.h>

int main(int argc, char** argv) {
  constexpr std::size_t kCache = 10'000'000;  // of rospack, which rosbag asks for its plugins [B]
  const auto import = [](const std::vector<std::string>& words) {
    cable_variation::Motion motion;
    cable_variation_ros::readBagHere(words[0], words[1], words[2], words[3], motion);
    return cable_variation_ros::bytesOf(motion);
  };
  return cable_variation::runImport(argc, argv, 4, import, kCache);
}
