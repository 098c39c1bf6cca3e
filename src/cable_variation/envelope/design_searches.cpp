#include <cable_variation/envelope/design_searches.h>

#include <algorithm>
#include <sstream>

#include <cable_variation/envelope/envelope_warning.h>
#include <cable_variation/equilibrium/require_converged.h>

namespace cable_variation {
namespace {

// Times of a phase that the design is followed through from one phase to the next.
constexpr std::size_t kFollowedTimes = 4;
constexpr double kShare = 0.1;  // of the whole work

// Follows the design through some times between two references.
void approach(EquilibriumSolver& following, const PhaseSearch& before, const MotionPhase& phase) {
  const SampleSpace& space = before.follower().reader().space();
  std::vector<double> times;
  const auto take = [&](const std::vector<double>& of) {
    const std::size_t step = std::max<std::size_t>(1, of.size() / kFollowedTimes);
    for (std::size_t i = 0; i < of.size(); i += step) {
      if (of[i] > before.follower().referenceTime() && of[i] < phase.reference) times.push_back(of[i]);
    }
  };
  take(before.times());
  take(phase.times);
  for (const double time : times) following.update(space.harness(space.designAt(time)));
}

void noticeJump(const ShapeFollower& before, const ShapeFollower& after, Envelope& envelope) {
  const SamplePlace place = after.reader().space().designAt(after.referenceTime());
  const FollowedShape followed = before.follow(place, false);
  if (followed.converged && !followed.jump) return;
  warn(envelope, "the design itself does not follow the motion smoothly between ", before.referenceTime(),
       " and ", after.referenceTime(), " s: it snaps or is lost on the way");
}

}  // namespace

std::vector<PhaseSearch> searchesAlongDesign(const StretchReader& reader, const EquilibriumSolver& solver,
                                             const std::vector<MotionPhase>& phases, double tolerance,
                                             ProgressReporter& report, Envelope& envelope) {
  std::vector<PhaseSearch> searches;
  searches.reserve(phases.size());
  EquilibriumSolver following = solver;
  const SampleSpace& space = reader.space();
  for (const MotionPhase& phase : phases) {
    const double done = static_cast<double>(searches.size()) / static_cast<double>(phases.size());
    report({"shapes", kShare * done, 0, phase.reference});
    if (!searches.empty()) approach(following, searches.back(), phase);
    const Harness harness = space.harness(space.designAt(phase.reference));
    const Equilibrium equilibrium = following.update(harness);
    std::ostringstream what;
    what << "the design has no equilibrium at " << phase.reference << " s";
    requireConverged(equilibrium, what.str());
    ShapeFollower follower(reader, following, harness, equilibrium, phase.reference);
    if (!searches.empty()) noticeJump(searches.back().follower(), follower, envelope);
    searches.emplace_back(std::move(follower), phase.times, tolerance);
  }
  return searches;
}

}  // namespace cable_variation
