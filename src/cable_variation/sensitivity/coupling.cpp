#include <cable_variation/sensitivity/coupling.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cable_variation {
namespace {

constexpr double kSmallEffect = 0.1;

// Per variable the measures that it moves.
std::vector<std::vector<Eigen::Index>> movedBy(const Eigen::MatrixXd& effects) {
  std::vector<std::vector<Eigen::Index>> moved(static_cast<std::size_t>(effects.cols()));
  for (Eigen::Index row = 0; row < effects.rows(); ++row) {
    const double largest = effects.cols() > 0 ? effects.row(row).cwiseAbs().maxCoeff() : 0.0;
    for (Eigen::Index column = 0; column < effects.cols(); ++column) {
      const double effect = std::abs(effects(row, column));
      if (effect > 0.0 && effect >= kSmallEffect * largest) {
        moved[static_cast<std::size_t>(column)].push_back(row);
      }
    }
  }
  return moved;
}

}  // namespace

const char* toString(Coupling coupling) {
  switch (coupling) {
    case Coupling::uncoupled:
      return "uncoupled";
    case Coupling::decoupled:
      return "decoupled";
    case Coupling::coupled:
      break;
  }
  return "coupled";
}

Coupling couplingOf(const Eigen::MatrixXd& effects) {
  std::vector<std::vector<Eigen::Index>> moved = movedBy(effects);
  if (std::all_of(moved.begin(), moved.end(), [](const auto& rows) { return rows.size() <= 1; })) {
    return Coupling::uncoupled;
  }
  // The measure tuned last has a variable that moves no other; the one before it a variable that moves no
  // other but that, and so on.
  while (true) {
    const auto own =
        std::find_if(moved.begin(), moved.end(), [](const auto& rows) { return rows.size() == 1; });
    if (own == moved.end()) break;
    const Eigen::Index tuned = own->front();
    for (auto& rows : moved) rows.erase(std::remove(rows.begin(), rows.end(), tuned), rows.end());
  }
  const bool all_tuned =
      std::all_of(moved.begin(), moved.end(), [](const auto& rows) { return rows.empty(); });
  return all_tuned ? Coupling::decoupled : Coupling::coupled;
}

}  // namespace cable_variation
