#pragma once  // internal to geometry/

// What the searches for closest pairs of cables with parts and with each other have in common.

#include <algorithm>
#include <vector>

namespace cable_variation {

constexpr double kOtherDirection =
    0.01;  ///< between directions from one to the other that count as two [rad]

/// The cells whose minimum `at` has a value up to `limit` [m], the smallest first.
template <class Cell>
std::vector<Cell> closestFirst(std::vector<Cell> cells, double limit) {
  cells.erase(
      std::remove_if(cells.begin(), cells.end(), [&](const Cell& cell) { return cell.at.value > limit; }),
      cells.end());
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.at.value < b.at.value; });
  return cells;
}

}  // namespace cable_variation
