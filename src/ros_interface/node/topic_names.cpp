#include <ros_interface/node/topic_names.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace cable_variation_ros {

std::vector<std::string> topicNames(const std::string& prefix, const std::vector<std::string>& names) {
  std::vector<std::string> topics;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    std::string legal = name;
    std::replace_if(
        legal.begin(), legal.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; }, '_');
    std::string topic = legal;
    for (int number = 2; !taken.insert(topic).second; ++number) topic = legal + "_" + std::to_string(number);
    topics.push_back(prefix + topic);
  }
  return topics;
}

}  // namespace cable_variation_ros
