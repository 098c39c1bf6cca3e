#include <ros_interface/request/name_registry.h>

#include <stdexcept>

namespace cable_variation_ros {

NameRegistry::Hold::Hold(NameRegistry& registry, const char* field, std::string name,
                         const std::string& holder)
    : registry_(registry), name_(std::move(name)) {
  if (name_.empty()) return;
  const std::lock_guard<std::mutex> lock(registry_.mutex_);
  const auto [place, added] = registry_.holders_.emplace(name_, holder);
  if (added) return;
  throw std::invalid_argument(std::string(field) + ": '" + name_ + "' is what a run of ~" + place->second +
                              " is writing now; expected another name, or wait until that has ended");
}

NameRegistry::Hold::~Hold() {
  if (name_.empty()) return;
  const std::lock_guard<std::mutex> lock(registry_.mutex_);
  registry_.holders_.erase(name_);
}

}  // namespace cable_variation_ros
