#include <cable_variation/envelope/rare_rounding.h>

#include <algorithm>

namespace cable_variation {
namespace {

// Stretches to both sides that are rounded as well: another shape sticks out a little further along.
constexpr std::size_t kAside = 1000;
constexpr double kFactor = 2.0;

}  // namespace

void RareRounding::add(const std::vector<RandomShape>& shapes) {
  for (const RandomShape& shape : shapes) {
    if (!shape.converged) continue;
    if (shape.of_rare.empty()) {
      usual_ = std::max(usual_, shape.protrusion);
      continue;
    }
    for (std::size_t i = 0; i < rare_.size(); ++i)
      rare_[i] = std::max(rare_[i], static_cast<double>(shape.of_rare[i]));
  }
}

std::vector<double> RareRounding::beyond(double inflation) const {
  std::vector<double> beyond(rare_.size());
  for (std::size_t i = 0; i < rare_.size(); ++i) {
    const std::size_t first = i - std::min(i, kAside), last = std::min(i + kAside, rare_.size() - 1);
    for (std::size_t k = first; k <= last; ++k)
      beyond[i] = std::max(beyond[i], kFactor * rare_[k] - inflation);
  }
  return beyond;
}

}  // namespace cable_variation
