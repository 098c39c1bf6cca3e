#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <cable_variation/util/error.h>
#include <cable_variation/util/name_list.h>

namespace cable_variation {

/// Where in `all` a name is. Throws NotFound, which proposes the nearest one, for a name
/// that is not there; `kind` says what is named.
template <typename Named>
std::size_t indexOf(const std::string& name, const std::vector<Named>& all, const char* kind) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return i;
    names.push_back(all[i].name);
  }
  throw NotFound(std::string("no ") + kind + " named '" + name + "'" + didYouMean(name, names));
}

/// Where in `all` the names of a request are. Throws as indexOf(), and std::invalid_argument for one given
/// twice; `kind` says what is named.
template <typename Named>
std::vector<std::size_t> indicesOf(const std::vector<std::string>& names, const std::vector<Named>& all,
                                   const char* kind) {
  std::vector<std::size_t> indices;
  for (const std::string& name : names) {
    const std::size_t index = indexOf(name, all, kind);
    if (std::find(indices.begin(), indices.end(), index) != indices.end()) {
      throw std::invalid_argument(std::string(kind) + " '" + name + "' is given twice");
    }
    indices.push_back(index);
  }
  return indices;
}

}  // namespace cable_variation
