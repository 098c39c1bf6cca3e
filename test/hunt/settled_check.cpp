#include <hunt/settled_check.h>

#include <algorithm>
#include <cmath>

#include <hunt/discrete_minimise.h>
#include <hunt/discrete_start.h>
#include <hunt/scales.h>

namespace cable_variation::hunt {

bool Settled::eigenvalueIsOff(double reported) const {
  for (const Clip& clip : rod.harness().clips) {
    // what a point of the cable does while the cable slides is not the same on every grid
    if (clip.constraint.slides) return false;
  }
  // its own may be of a motion that costs nothing, which the answer leaves out
  if (std::abs(eigenvalue) <= eigenvalue_unclear) return reported < -eigenvalue_unclear;
  const double own_error = std::abs(eigenvalue - eigenvalue_coarse);
  // where the grids differ by more, the shape itself is not known well enough
  if (!decided || own_error > 0.1 * std::abs(eigenvalue)) return false;
  return std::abs(reported - eigenvalue) > 0.01 * std::abs(eigenvalue) + 0.5 * own_error + eigenvalue_unclear;
}

Settled settleFrom(const Harness& harness, const Equilibrium& answer, std::size_t segments) {
  constexpr double kNear = 0.02;  // of the length: grids further apart are not near one shape
  const DiscreteLayout coarse = layOut(harness, segments), fine = halved(coarse);
  Settled settled{DiscreteRod(harness, coarse)};
  const DiscreteRod finer(harness, fine);
  const DiscreteShape reported = startAt(finer, answer);
  settled.shape = startAt(settled.rod, answer);
  DiscreteShape on_fine = reported;
  if (!settle(settled.rod, settled.shape).stationary || !settle(finer, on_fine).stationary) {
    settled.text = "the independent rod does not settle";
    return settled;
  }
  for (std::size_t i = 0; i < fine.pieces.size(); ++i) {
    for (std::size_t k = 0; k <= coarse.pieces[i].segments(); ++k) {
      const Eigen::Vector3d a = settled.shape.vertex(coarse.pieces[i], i, k);
      const Eigen::Vector3d b = on_fine.vertex(fine.pieces[i], i, 2 * k);
      const Eigen::Vector3d beyond = b + (b - a) / 3.0;
      settled.off = std::max(settled.off, (beyond - reported.vertex(fine.pieces[i], i, 2 * k)).norm());
      settled.grids = std::max(settled.grids, (b - a).norm());
    }
  }
  const double length = longestLength(harness);
  if (settled.grids > kNear * length) {
    settled.text = textOf("the independent grids differ by ", 1e3 * settled.grids, " mm");
    return settled;
  }
  settled.decided = true;
  constexpr double kRelative = 1e-3;
  settled.eigenvalue_coarse = smallestEigenvalue(settled.rod, settled.shape, kRelative);
  const double eigenvalue_fine = smallestEigenvalue(finer, on_fine, kRelative);
  settled.eigenvalue = eigenvalue_fine + (eigenvalue_fine - settled.eigenvalue_coarse) / 3.0;
  const double count = static_cast<double>(segments);
  settled.eigenvalue_unclear =
      (1e-3 + 1e-15 * slendernessOf(harness) * count * count) * bendingScale(harness) / (length * length);
  return settled;
}

}  // namespace cable_variation::hunt
