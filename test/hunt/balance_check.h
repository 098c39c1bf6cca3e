#pragma once

#include <string>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation::hunt {

/// A way in which an answer is wrong, and by how much of what is allowed; 1 or less: it is right.
struct Violation {
  double times = 0.0;
  std::string what;

  void worst(double value, double allowed, const std::string& of) {
    const double ratio = value / allowed;
    if (ratio > times || !(ratio == ratio)) {
      times = ratio == ratio ? ratio : 1e300;
      what = of;
    }
  }
};

/// Forces and moments jump at clips, joints and loads by what those give, free ends bear nothing, and all of
/// them together with the weight balance. Forces count against the largest in the harness.
Violation checkBalance(const Harness& harness, const Equilibrium& answer);

/// Every clip and joint holds what it locks, bears nothing where it is free, pulls back as its springs do,
/// turns by at most π, and where it slides the configurational force is continuous (doc/theory.md).
Violation checkHolds(const Harness& harness, const Equilibrium& answer);

/// The equations of the rod hold between the reported points: each integrated from one to the next (and to
/// half way, against the reported centreline between). `accuracy` [m] is that of the centreline.
Violation checkEquations(const Harness& harness, const Equilibrium& answer, double accuracy);

}  // namespace cable_variation::hunt
