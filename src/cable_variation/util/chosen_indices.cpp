#include <cable_variation/util/chosen_indices.h>

#include <numeric>
#include <stdexcept>
#include <string>

namespace cable_variation {

std::vector<std::size_t> allIndices(std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::vector<std::size_t> allOrChosen(const std::vector<std::size_t>& chosen, std::size_t count,
                                     const char* kind) {
  for (const std::size_t index : chosen) {
    if (index >= count) {
      throw std::invalid_argument(std::string(kind) + " number " + std::to_string(index) +
                                  "; expected less than " + std::to_string(count));
    }
  }
  return chosen.empty() ? allIndices(count) : chosen;
}

}  // namespace cable_variation
