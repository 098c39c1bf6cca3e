#include <cable_variation/variation/envelope_assembly.h>

#include <algorithm>

#include <cable_variation/variation/envelope_warning.h>

namespace cable_variation {
namespace {

using Branch = PhaseSearch::Branch;

// Branches of different phases are the same if they begin close together. The first of those known is the
// design's own, which all phases share.
std::size_t globalBranch(const Branch& branch, std::vector<const Branch*>& known) {
  for (std::size_t i = 1; i < known.size(); ++i) {
    const double apart = largestDistance(known[i]->first_ends, branch.first_ends).distance;
    if (apart < 0.5 * std::min(known[i]->jump, branch.jump)) return i;
  }
  known.push_back(&branch);
  return known.size() - 1;
}

void addPieces(const PhaseSearch& search, std::size_t phase, std::size_t branch, std::size_t global_branch,
               std::size_t first_sample, Envelope& envelope) {
  const std::vector<MaterialStretch>& stretches = search.follower().reader().stretches();
  for (std::size_t frame = 0; frame < envelope.frames.size(); ++frame) {
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const GrowingHull& hull = search.branches()[branch].hulls[frame][i];
      EnvelopePiece piece{stretches[i].cable,
                          stretches[i].start,
                          stretches[i].end,
                          phase,
                          global_branch,
                          {hull.hull(), search.radius()[i] + envelope.inflation},
                          {}};
      piece.vertex_sample.reserve(hull.tags().size());
      for (const GrowingHull::Tag& tag : hull.tags())
        piece.vertex_sample.push_back(first_sample + tag.sample);
      envelope.frames[frame].pieces.push_back(std::move(piece));
    }
  }
}

void addPhase(const PhaseSearch& search, std::size_t phase, std::vector<const Branch*>& known,
              Envelope& envelope) {
  envelope.phases.push_back({search.times().front(), search.times().back(), search.times().size()});
  envelope.solves += search.solves();
  envelope.failures += search.failures();
  envelope.discretisation_error = std::max(envelope.discretisation_error, search.discretisationError());
  std::vector<std::size_t> global{0};
  for (std::size_t b = 1; b < search.branches().size(); ++b) {
    global.push_back(globalBranch(search.branches()[b], known));
  }
  const std::size_t first_sample = envelope.samples.size();
  for (std::size_t i = 0; i < search.samples().size(); ++i) {
    const SamplePlace& place = search.samples()[i].place;
    envelope.samples.push_back({place.deviations, place.time, phase, global[search.sampleBranches()[i]]});
  }
  for (Snap snap : search.snaps()) {
    snap.branch = global[snap.branch];
    envelope.snaps.push_back(std::move(snap));
  }
  for (std::size_t b = 0; b < search.branches().size(); ++b) {
    addPieces(search, phase, b, global[b], first_sample, envelope);
  }
}

void warnOfShortcomings(const std::vector<PhaseSearch>& searches, std::size_t largest_solves,
                        Envelope& envelope) {
  std::size_t exhausted = 0;
  for (const PhaseSearch& search : searches) exhausted += search.exhausted() ? 1 : 0;
  if (exhausted > 0) {
    warn(envelope, exhausted, " of ", searches.size(), " phases ended at the largest number of solves, ",
         largest_solves, ": their hulls may still grow");
  }
  if (envelope.failures > 0) {
    const auto first = std::find_if(searches.begin(), searches.end(),
                                    [](const PhaseSearch& search) { return search.failures() > 0; });
    warn(envelope, envelope.failures,
         " harnesses within the tolerances have no equilibrium that the design's leads to, ",
         "and are not in the envelope; the first: ", first->failure());
  }
}

}  // namespace

void assembleEnvelope(const std::vector<PhaseSearch>& searches, std::size_t largest_solves,
                      Envelope& envelope) {
  const std::vector<std::string>& frames = searches.front().follower().reader().frames();
  envelope.frames.resize(frames.size());
  for (std::size_t frame = 0; frame < frames.size(); ++frame)
    envelope.frames[frame].component = frames[frame];
  std::vector<const Branch*> known{nullptr};
  for (std::size_t phase = 0; phase < searches.size(); ++phase)
    addPhase(searches[phase], phase, known, envelope);
  envelope.branches = known.size();
  warnOfShortcomings(searches, largest_solves, envelope);
}

}  // namespace cable_variation
