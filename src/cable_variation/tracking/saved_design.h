#pragma once

#include <string>
#include <utility>
#include <vector>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/scene/design.h>

namespace cable_variation {

/// The shape that a design had, enough of it to come to rest there again.
struct SavedShape {
  std::vector<CableShape> shapes;                    ///< one per cable; empty: there was none
  std::vector<std::pair<std::size_t, double>> slid;  ///< where clips that slide hold their cables: clip, [m]
};

struct SavedDesign {
  Design design;
  SavedShape shape;
};

/// A design and its shape as lines of text that are read back as exactly the same numbers: nominal values,
/// poses, lengths, sections, rest shapes, clips that were added, opened or closed. What no edit changes is
/// the scene's.
/// @param loaded the scene that the design was made from
/// @param shape of the design, the last one that it had; not converged: none
std::string savedDesignText(const Design& design, const Scene& loaded, const Equilibrium& shape);

/// Reads such a text. Throws std::invalid_argument that names the line, for a text that is not whole, or is
/// not of a design of `loaded`.
SavedDesign readSavedDesign(const std::string& text, const Scene& loaded);

/// The equilibrium that the shape comes to rest in; without a shape, or where it leads to none, as
/// EquilibriumSolver::solve().
Equilibrium solveSaved(EquilibriumSolver& solver, const Harness& harness, const SavedShape& shape);

}  // namespace cable_variation
