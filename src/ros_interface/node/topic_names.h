#pragma once

#include <string>
#include <vector>

namespace cable_variation_ros {

/// A topic below `prefix` for each of `names`: what ROS does not allow in a name (- and .) becomes _, and of
/// names that are then the same the later ones end in _2, _3, ...
std::vector<std::string> topicNames(const std::string& prefix, const std::vector<std::string>& names);

}  // namespace cable_variation_ros
