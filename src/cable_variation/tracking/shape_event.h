#pragma once

#include <optional>
#include <string>
#include <vector>

#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/scene/measure.h>
#include <cable_variation/tracking/clip_attachment.h>

namespace cable_variation {

/// Something that happened to the cables from one shape to the next.
struct ShapeEvent {
  enum class Kind {
    snapped,           ///< a cable jumped to another equilibrium: the one it was in ended
    equilibrium_lost,  ///< none was found
    overstretched,     ///< none can exist
    equilibrium_back,  ///< after one of the two above
    limit_broken,      ///< of a measure
    limit_kept,        ///< again
    clip_closed,       ///< it has taken hold of its cable
    clip_opened,       ///< it has let go of its cable
    clip_refused       ///< it was to close or open and could not
  };

  Kind kind = Kind::snapped;
  std::string cable, measure, clip;  ///< names; empty: it is of none
  std::string text;                  ///< for a person
  double arc_length = 0.0;           ///< on the cable [m]
  double from_value = 0.0;  ///< total energy before a snap or a clip's change [J]; the measure's value
  double to_value = 0.0;    ///< likewise after it
  double distance = 0.0;    ///< that the cable went, at most [m]
};

/// Whether it is one of those that nobody wants.
bool isFault(ShapeEvent::Kind kind);

/// A few words for it: "snap", "D_CAR out of its limits".
std::string shortText(const ShapeEvent& event);

/// @param harness in which it happened
ShapeEvent snapEvent(const Harness& harness, const ShapeJump& jump);

/// What clips did: the whole change is told with each of them.
/// @param before per clip, whether it was attached
std::vector<ShapeEvent> clipEvents(const std::vector<bool>& before, const Harness& harness,
                                   const AttachedClips& attached);

/// An equilibrium lost or found again; neither: none. @param before whether there was one
std::optional<ShapeEvent> equilibriumEvent(bool before, const Equilibrium& equilibrium);

/// Tells of limits that are broken and kept again.
class LimitWatch {
 public:
  /// What changed since the last call; at the first, which limits are broken. @param values one per measure
  std::vector<ShapeEvent> compare(const std::vector<Measure>& measures,
                                  const std::vector<MeasureValue>& values);

 private:
  struct Known {
    double value = 0.0;
    bool within = true;
  };
  std::vector<Known> known_;
};

}  // namespace cable_variation
