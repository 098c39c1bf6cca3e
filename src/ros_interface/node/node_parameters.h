#pragma once

#include <string>

#include <cable_variation/util/input_limits.h>
#include <ros_interface/node/default_output_directory.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

struct StaticGeometryParameters {
  std::string
      scene;  ///< path or package:// address of the scene file; empty, and `follow`: none to begin with
  bool follow = false;                  ///< show what a cable_solver has loaded
  cable_variation::InputLimits limits;  ///< of files that are read
};

struct MovingGeometryParameters {
  std::string scene;
  bool follow = false;
  double rate_hz = 50.0;                       ///< of the transforms
  bool loop = true;                            ///< start again at the end
  double speed = 1.0;                          ///< seconds of motion per second
  std::string joint_states = "/joint_states";  ///< topic that robots' links follow
  cable_variation::InputLimits limits;         ///< of files that are read
};

struct CableSolverParameters {
  std::string scene;
  bool live = false;            ///< follow the components on tf
  double live_rate_hz = 200.0;  ///< how often to follow, at most
  double tf_timeout = 1.0;      ///< how old tf may be before it is told [s]
  bool interactive = true;      ///< clips and components can be dragged in RViz
  bool live_topics = false;     ///< a topic for each measure too
  std::size_t threads = 0;      ///< for envelopes; 0: as many as there are cores
  double memory_limit = 2e9;    ///< for one envelope or simulation [B]
  double memory_total = 8e9;    ///< for all that are at work at once [B]; at least memory_limit
  /// Where files are written; made when there is something to write.
  std::string output_directory = defaultOutputDirectory();
  std::string state_file;  ///< where what is in force is kept for the next start; empty: it is not
  std::string author;      ///< named in reports; empty: not
  cable_variation::InputLimits limits;  ///< of files that are read
};

// Each reads the parameters of a node's private handle. Throws
// std::invalid_argument that lists every missing parameter, wrong type and value
// out of bounds.
StaticGeometryParameters readStaticGeometryParameters(const ros::NodeHandle& node);
MovingGeometryParameters readMovingGeometryParameters(const ros::NodeHandle& node);
CableSolverParameters readCableSolverParameters(const ros::NodeHandle& node);

}  // namespace cable_variation_ros
