#pragma once

#include <map>
#include <mutex>
#include <string>

namespace cable_variation_ros {

/// The names under which the node's services and actions are writing files now: one of them at a time writes
/// the files of a name. Safe from several threads.
class NameRegistry {
 public:
  /// Holds a name until it goes away.
  class Hold {
   public:
    /// @param name empty: no files, nothing is held
    /// @param holder who writes, for the message to others, such as "generate_envelope"
    /// Throws std::invalid_argument that names `field`, the name and who holds it.
    Hold(NameRegistry& registry, const char* field, std::string name, const std::string& holder);
    ~Hold();
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   private:
    NameRegistry& registry_;
    std::string name_;
  };

 private:
  std::mutex mutex_;
  std::map<std::string, std::string> holders_;  // by name
};

}  // namespace cable_variation_ros
