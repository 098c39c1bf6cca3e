#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <ros/node_handle.h>
#include <ros/time.h>
#include <ros/wall_timer.h>

namespace cable_variation_ros {

class SolverContext;

/// ~state_file: the scene, the design in force and its shape, kept for the node's next start. There complete
/// or not at all.
class StateFile {
 public:
  /// @param path empty: nothing is kept
  /// @param asked the scene that the node is started with, as the parameter has it
  StateFile(const ros::NodeHandle& node, std::string path, std::string asked);

  /// Puts into force what the file has, if it is of this node and this scene and the scene's file is as it
  /// was. Else the context stays as it is, the log says why, and the file is kept beside its place, as
  /// PATH.old; one that no solver has written is left alone, and nothing is kept then.
  void restore(SolverContext& context);

  /// Writes what is in force, if it is another design: at once, or after so short a time that dragging does
  /// not wait for disks.
  void contextChanged(const SolverContext& context);

 private:
  void write();
  void restoreFrom(const std::string& text, SolverContext& context) const;

  ros::NodeHandle node_;
  std::string path_;
  std::string asked_;
  const SolverContext* context_ = nullptr;
  std::optional<std::size_t> written_;  ///< SolverContext::designNumber()
  ros::WallTime last_;                  ///< when
  ros::WallTimer later_;
};

}  // namespace cable_variation_ros
