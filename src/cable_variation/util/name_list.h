#pragma once

#include <string>
#include <vector>

namespace cable_variation {

/// "; did you mean 'length'?" for the candidate nearest to `name`; else, if there
/// are few, "; known: a, b"; else nothing.
std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates);

/// "a, b, c"
std::string joined(const std::vector<std::string>& words);

}  // namespace cable_variation
