#pragma once  // internal to equilibrium/

#include <cable_variation/equilibrium/derivatives/linear_response.h>
#include <cable_variation/equilibrium/discretisation/problem.h>

namespace cable_variation {

/// How the smallest eigenvalue of a problem's Hessian changes with variables. With
/// the motion v of the eigenvalue fixed, its derivative is that of the quotient
/// vᵀHv / vᵀNv along the equilibrium's first-order response: differences, of
/// fourth order, of quotients a little to both sides; nothing is solved again.
class EigenvalueRate {
 public:
  /// `problem` is at its equilibrium. Keeps a reference.
  explicit EigenvalueRate(const Problem& problem);

  double of(const HarnessRate& variable, const HarnessChange& change, const HarnessResponse& response);

 private:
  double quotientAt(double step, const HarnessRate& variable, const HarnessChange& change,
                    const HarnessResponse& response);

  const Problem& problem_;
  Problem aside_;
  NodalField mode_;
};

}  // namespace cable_variation
