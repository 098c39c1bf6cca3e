#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <cable_variation/util/error.h>

namespace cable_variation_ros {

/// Where in `all` the names of a request are. Throws cable_variation::NotFound for a name that is not there,
/// and std::invalid_argument for one given twice; `kind` says what is named.
template <typename Named>
std::vector<std::size_t> indicesOf(const std::vector<std::string>& names, const std::vector<Named>& all,
                                   const char* kind) {
  std::vector<std::size_t> indices;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Named& each) { return each.name == name; });
    if (found == all.end()) {
      throw cable_variation::NotFound(std::string("no ") + kind + " named '" + name + "'");
    }
    const auto index = static_cast<std::size_t>(found - all.begin());
    if (std::find(indices.begin(), indices.end(), index) != indices.end()) {
      throw std::invalid_argument(std::string(kind) + " '" + name + "' is given twice");
    }
    indices.push_back(index);
  }
  return indices;
}

}  // namespace cable_variation_ros
