#include <cable_variation/envelope/envelope_assembly.h>

#include <algorithm>

#include <cable_variation/envelope/envelope_memory.h>
#include <cable_variation/envelope/envelope_warning.h>

namespace cable_variation {
namespace {

void addPieces(const PhaseSearch& search, std::size_t phase, const PhaseSearch::Cluster& cluster,
               std::size_t global_branch, std::size_t first_sample, Envelope& envelope) {
  const std::vector<MaterialStretch>& stretches = search.follower().reader().stretches();
  for (std::size_t frame = 0; frame < envelope.frames.size(); ++frame) {
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const GrowingHull& hull = cluster.hulls[frame][i];
      EnvelopePiece piece{stretches[i].cable,
                          stretches[i].start,
                          stretches[i].end,
                          phase,
                          global_branch,
                          {hull.hull(), search.pieceRadius(cluster, i) + envelope.inflation},
                          {}};
      piece.vertex_sample.reserve(hull.tags().size());
      for (const GrowingHull::Tag& tag : hull.tags())
        piece.vertex_sample.push_back(first_sample + tag.sample);
      envelope.frames[frame].pieces.push_back(std::move(piece));
    }
  }
}

void addPhase(const PhaseSearch& search, std::size_t phase, const std::vector<std::size_t>& global,
              Envelope& envelope) {
  envelope.phases.push_back({search.times().front(), search.times().back(), search.times().size()});
  envelope.solves += search.solves();
  envelope.failures += search.failures();
  envelope.discretisation_error = std::max(envelope.discretisation_error, search.discretisationError());
  const std::size_t first_sample = envelope.samples.size();
  for (std::size_t i = 0; i < search.samples().size(); ++i) {
    const SamplePlace& place = search.samples()[i].place;
    envelope.samples.push_back({place.deviations, place.time, phase, global[search.sampleBranches()[i]]});
  }
  for (std::size_t b = 1; b < search.branches().size(); ++b) {
    Snap snap = search.branches()[b].nearest;
    snap.branch = global[b];
    const auto known = std::find_if(envelope.snaps.begin(), envelope.snaps.end(),
                                    [&](const Snap& each) { return each.branch == snap.branch; });
    if (known == envelope.snaps.end()) {
      envelope.snaps.push_back(std::move(snap));
    } else if (snap.begins < known->begins) {
      *known = std::move(snap);
    }
  }
  for (const PhaseSearch::Cluster& cluster : search.clusters()) {
    addPieces(search, phase, cluster, global[cluster.branch], first_sample, envelope);
  }
}

void warnOfShortcomings(const std::vector<PhaseSearch>& searches, std::size_t largest_solves,
                        Envelope& envelope) {
  const auto endedAt = [&](SearchEnd end) {
    return std::count_if(searches.begin(), searches.end(),
                         [&](const PhaseSearch& search) { return search.end() == end; });
  };
  if (const auto ended = endedAt(SearchEnd::most_solves); ended > 0) {
    warn(envelope, ended, " of ", searches.size(), " phases ended at the largest number of solves, ",
         largest_solves, ": their hulls may still grow");
  }
  if (const auto ended = endedAt(SearchEnd::most_shapes); ended > 0) {
    warn(envelope, ended, " of ", searches.size(),
         " phases ended at the most shapes that memory is enough for: their hulls may still grow");
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

// Branches of different phases are the same if the jumps to them move the cables alike.
std::vector<std::vector<std::size_t>> branchNumbers(const std::vector<PhaseSearch>& searches) {
  std::vector<const Eigen::Matrix3Xd*> known{nullptr};
  std::vector<std::vector<std::size_t>> numbers;
  for (const PhaseSearch& search : searches) {
    numbers.push_back({0});
    for (std::size_t b = 1; b < search.branches().size(); ++b) {
      const Eigen::Matrix3Xd& motion = search.branches()[b].motion;
      const auto same = std::find_if(known.begin() + 1, known.end(), [&](const Eigen::Matrix3Xd* other) {
        return other->cwiseProduct(motion).sum() > PhaseSearch::kAlike * other->norm() * motion.norm();
      });
      numbers.back().push_back(static_cast<std::size_t>(same - known.begin()));
      if (same == known.end()) known.push_back(&motion);
    }
  }
  return numbers;
}

void assembleEnvelope(const std::vector<PhaseSearch>& searches, std::size_t largest_solves,
                      Envelope& envelope) {
  const std::vector<std::string>& frames = searches.front().follower().reader().frames();
  envelope.frames.resize(frames.size());
  for (std::size_t frame = 0; frame < frames.size(); ++frame)
    envelope.frames[frame].component = frames[frame];
  const std::vector<std::vector<std::size_t>> global = branchNumbers(searches);
  for (std::size_t phase = 0; phase < searches.size(); ++phase) {
    addPhase(searches[phase], phase, global[phase], envelope);
    for (const std::size_t branch : global[phase])
      envelope.branches = std::max(envelope.branches, branch + 1);
  }
  warnOfShortcomings(searches, largest_solves, envelope);
}

void warnOfCoarsening(const std::vector<PhaseSearch>& searches, std::size_t wanted, std::size_t most,
                      double memory_limit, double tolerance, Envelope& envelope) {
  if (wanted > most) {
    warn(envelope, "the motion has ", wanted, " phases; ", searches.size(),
         " longer ones are taken, for which ", memoryText(memory_limit),
         " are enough: their bodies span up to ", 1e3 * envelope.motion_excess,
         " mm beyond the way of a clip");
  }
  double coarsest = 0.0;
  std::size_t coarser = 0;
  for (const PhaseSearch& search : searches) {
    coarsest = std::max(coarsest, search.tolerance());
    coarser += search.tolerance() > tolerance ? 1 : 0;
  }
  if (coarser > 0) {
    warn(envelope, coarser, " of ", searches.size(), " phases leave gains of up to ", 1e3 * coarsest,
         " mm to the inflation: over a motion ", kSolvesOverMotion, " solves are shared among the phases");
  }
}

}  // namespace cable_variation
