#pragma once

#include <cstddef>
#include <string>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/tracking/stretch_shape.h>

namespace cable_variation {

struct EnvelopeOptions;

/// How much memory the parts of an envelope take while it is made [B], about: bounds of what was measured.
struct EnvelopeMemory {
  double shape = 0.0;  ///< a solved one that the search of a phase keeps, with its derivatives
  double phase = 0.0;  ///< one that is done: its pieces, and the design's shape to follow
  double hulls = 0.0;  ///< of all stretches and frames, once

  /// Shares of the limit: for phases that are done, for searches under way, for random shapes, for the voxels
  /// of tightness once the searches have ended.
  static constexpr double kForPhases = 0.35, kForSearches = 0.25, kForRandomShapes = 0.25, kForVoxels = 0.5;

  EnvelopeMemory() = default;
  /// @param shape of the design, with rates
  EnvelopeMemory(const StretchShape& shape, const Equilibrium& design);

  /// Phases that a limit [B] is enough for; at least one.
  std::size_t mostPhases(double limit) const;
  /// Shapes that each search may keep within a limit [B], with as many under way as there are threads, or
  /// phases if they are fewer. A single phase has the share of others, too.
  std::size_t mostShapes(double limit, std::size_t phases) const;
  /// What a search takes that keeps so many shapes in so many clusters [B].
  double ofSearch(std::size_t shapes, std::size_t clusters) const;
};

/// Throws std::invalid_argument if what is asked for would surely take more than `options.memory_limit`, with
/// the field, its value, what it would take and what is allowed.
void refuseMoreThanMemory(const EnvelopeOptions& options, const EnvelopeMemory& memory,
                          const Equilibrium& design);

/// "2.5 GB", for a person.
std::string memoryText(double bytes);

}  // namespace cable_variation
