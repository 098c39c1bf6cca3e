#pragma once

#include <csignal>

#include <ros/init.h>
#include <ros/node_handle.h>
#include <ros/console.h>

namespace cable_variation_ros {

/// Runs a node until it is told to stop: reads its parameters, makes it, spins.
/// What its making throws is logged, and the exit code is then 1.
template <typename Node, typename Parameters>
int runNode(int argc, char** argv, const char* name, Parameters (*read_parameters)(const ros::NodeHandle&)) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error that is told, not the end
  ros::init(argc, argv, name);
  ros::NodeHandle node("~");
  try {
    Node running(node, read_parameters(node));
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}

}  // namespace cable_variation_ros
