#include <cable_variation/equilibrium/neutral_note.h>

namespace cable_variation {

const std::string kNeutralNote = "neutral, at no cost in energy and left out of the smallest eigenvalue: ";

std::string neutralNote(const Equilibrium& equilibrium) {
  for (const std::string& note : equilibrium.notes) {
    if (note.compare(0, kNeutralNote.size(), kNeutralNote) == 0) return note;
  }
  return "";
}

}  // namespace cable_variation
