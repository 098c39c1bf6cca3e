#pragma once

#include <csignal>
#include <cstdio>
#include <string>

#include <ros/console.h>
#include <ros/init.h>
#include <ros/node_handle.h>

#include <ros_interface/node/node_end.h>

namespace cable_variation_ros {

/// Whether one of the arguments asks for help.
inline bool asksForHelp(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--help" || argument == "-h") return true;
  }
  return false;
}

/// Runs a node until it is told to stop: reads its parameters, makes it, spins.
/// What its making throws is logged, and the exit code is then 1. Asked for help, it prints `help` and takes
/// no master.
template <typename Node, typename Parameters>
int runNode(int argc, char** argv, const char* name, const char* help,
            Parameters (*read_parameters)(const ros::NodeHandle&)) {
  if (asksForHelp(argc, argv)) {
    std::printf(
        "usage: %s [_PARAMETER:=VALUE ...] [TOPIC:=TOPIC ...]\n\n%s\ndoc/nodes.md has topics and services.\n",
        name, help);
    return 0;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error that is told, not the end
  ros::init(argc, argv, name, ros::init_options::NoSigintHandler);
  endOnSignals();
  ros::NodeHandle node("~");
  endOnRequest();
  try {
    Node running(node, read_parameters(node));
    spinUntilTheEnd();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}

}  // namespace cable_variation_ros
