#pragma once

#include <Eigen/Core>

namespace cable_variation {

/// How a design's measures hang together by its variables (Suh, The Principles of
/// Design, 1990: the independence axiom).
enum class Coupling {
  uncoupled,  ///< no variable moves more than one measure
  decoupled,  ///< there is an order of tuning in which nothing already tuned is undone
  coupled     ///< tuning one measure undoes another
};

const char* toString(Coupling coupling);

/// @param effects of variables (columns) on measures (rows), of the tolerance: those below a tenth of the
/// row's largest count as none
Coupling couplingOf(const Eigen::MatrixXd& effects);

}  // namespace cable_variation
