#include <cable_variation/equilibrium/search/lowest_shape.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <cable_variation/equilibrium/discretisation/equilibrium_result.h>
#include <cable_variation/equilibrium/search/initial_shape.h>
#include <cable_variation/equilibrium/search/led_out.h>
#include <cable_variation/equilibrium/search/start_search.h>
#include <cable_variation/equilibrium/search/twist.h>
#include <cable_variation/equilibrium/search/unheld.h>

namespace cable_variation {
namespace {

// How much more than the best shape's energy changed by refinement those of others may.
constexpr double kDoubt = 3.0;
// Of the energy: shapes closer than this on one grid are mirror images, with the same error.
constexpr double kTwins = 1e-7;

// A shape that was refined.
struct Refined {
  std::unique_ptr<Branch> branch;
  Equilibrium result;
  double start_energy = 0.0;  // on the start grid [J]
  double energy = 0.0;        // [J]
  int departures = 0;
};

// One that was not chosen.
struct Other {
  double energy;  // [J]
  Grid grid;
  Configuration configuration;
};

class LowestShape {
 public:
  LowestShape(const Harness& harness, const EquilibriumOptions& options, Equilibrium& result)
      : harness_(harness), options_(options), result_(result) {}

  std::unique_ptr<Branch> find() {
    std::unique_ptr<Branch> branch = start();
    const SearchResult found = search(*branch);
    if (!result_.message.empty()) return nullptr;
    const bool stable = !found.minima.empty();
    for (const FoundShape& shape : stable ? found.minima : found.saddles) consider(shape, !stable, branch);
    if (!best_.branch) {
      result_.status = first_failure_.status;
      result_.message = first_failure_.message;
      return nullptr;
    }
    result_.shapes = std::move(best_.result.shapes);
    result_.residual = best_.result.residual;
    result_.discretisation_error = best_.result.discretisation_error;
    describeOthers();
    noteTwist();
    return std::move(best_.branch);
  }

 private:
  // A branch on the start grid, without moments that have no potential.
  std::unique_ptr<Branch> start() {
    auto branch = std::make_unique<Branch>(harness_, options_);
    conservative_ = branch->problem().system->conservative();
    if (!conservative_) branch->dropMoments();
    return branch;
  }

  SearchResult search(Branch& branch) {
    Problem& problem = branch.problem();
    const InitialShape initial(problem.harness, problem.topology);
    problem.configuration =
        initial.make(problem.system->grid(), std::vector<Routing>(initial.intervals().size()));
    result_.message = unreachable(problem.harness, problem.topology, problem.configuration, kLargestStretch);
    if (!result_.message.empty()) {
      result_.status = EquilibriumStatus::impossible;
      return {};
    }
    problem.system->soften(kSearchSlenderness, problem.configuration);
    SearchResult found = searchStarts(problem, options_, result_);
    if (found.minima.empty() && found.saddles.empty()) {
      result_.status = EquilibriumStatus::not_converged;
      const std::string unheld = unheldCables(harness_);
      result_.message =
          "no start led to an equilibrium: " + (unheld.empty() ? "" : unheld + "; ") + found.failure;
    }
    return found;
  }

  // Takes a shape for the best one, for an alternative, or not at all. `fresh`: a branch on the start grid
  // for the first that needs one.
  void consider(const FoundShape& shape, bool saddle, std::unique_ptr<Branch>& fresh) {
    if (best_.branch && shape.departures > best_.departures) {
      // not what was asked for
      if (shape.energy > best_.energy) others_.push_back({shape.energy, start_grid_, shape.configuration});
      return;
    }
    if (best_.branch) {
      const double change = best_.energy - best_.start_energy;
      const double apart = shape.energy - best_.start_energy;
      const double scale = std::abs(best_.energy) + std::abs(shape.energy);
      const bool twin = std::abs(apart) < kTwins * scale;
      if (twin || shape.energy > best_.energy + kDoubt * std::abs(change)) {
        others_.push_back(
            {std::max(shape.energy + (twin ? change : 0.0), best_.energy), start_grid_, shape.configuration});
        return;
      }
    }
    Refined refined;
    refined.branch = fresh ? std::move(fresh) : start();
    if (start_grid_.empty()) start_grid_ = refined.branch->problem().system->grid();
    refined.start_energy = shape.energy;
    refined.departures = shape.departures;
    if (!refine(shape, saddle, refined)) {
      if (first_failure_.message.empty()) first_failure_ = refined.result;
      return;
    }
    if (best_.branch && refined.energy >= best_.energy) {
      addAlternative(refined.energy, refined);
      return;
    }
    std::swap(best_, refined);
    if (refined.branch) addAlternative(refined.energy, refined);
  }

  bool refine(const FoundShape& shape, bool saddle, Refined& refined) {
    Branch& branch = *refined.branch;
    Equilibrium& result = refined.result;
    branch.problem().configuration = shape.configuration;
    branch.setUnstable(saddle);
    const bool found = branch.tighten(result) && (conservative_ || branch.growMoments(harness_, result)) &&
                       brought(branch, result);
    result_.iterations += result.iterations;
    if (!found && result.message.empty()) {
      const Problem& problem = branch.problem();
      std::ostringstream text;
      text << "a shape was found, but not to the accuracy of " << 1e3 * options_.accuracy
           << " mm; estimated error " << 1e3 * result.discretisation_error << " mm; "
           << whereItFailed(problem.harness, problem.topology, *problem.system, problem.configuration);
      result.status = EquilibriumStatus::not_converged;
      result.message = text.str();
    }
    if (found) refined.energy = branch.problem().system->energy().total();
    return found;
  }

  static bool brought(Branch& branch, Equilibrium& result) {
    branch.problem().system->evaluate(branch.problem().configuration, RodSystem::Hessian::none);
    return branch.adaptGrid(result);
  }

  // Twist that was asked for and is not there has become writhe: the cable winds about itself instead.
  void noteTwist() {
    const Problem& problem = best_.branch->problem();
    const std::vector<TwistPiece> pieces =
        twistPieces(problem.harness, problem.topology, problem.configuration);
    for (std::size_t c = 0; c < problem.harness.cables.size(); ++c) {
      const Cable& cable = problem.harness.cables[c];
      if (!cable.twist || pieces.empty()) continue;
      const double twist = twistOf(pieces, c);
      if (std::abs(twist - *cable.twist) <= M_PI) continue;
      std::ostringstream text;
      text << "cable '" << cable.name << "': its twist is " << twist << " rad instead of the " << *cable.twist
           << " rad asked for; the rest has become writhe: it winds about itself";
      result_.notes.push_back(text.str());
    }
  }

  void addAlternative(double energy, const Refined& other) {
    const Problem& problem = other.branch->problem();
    others_.push_back({energy, problem.system->grid(), problem.configuration});
  }

  // Two starts may have led to the answer, whose energies rounding tells apart where both are nothing.
  void describeOthers() {
    constexpr double kSame = 1e-6, kNothing = 1e-9;  // of the energies; of what bends a cable by a radian
    const Problem& best = best_.branch->problem();
    const double nothing = kNothing * best.system->bendingStiffness(0) / best.length();
    for (const Other& other : others_) {
      const double distance =
          largestDistance(best.system->grid(), best.configuration, other.grid, other.configuration);
      const double scale = std::abs(other.energy) + std::abs(best_.energy);
      if (distance <= options_.accuracy && std::abs(other.energy - best_.energy) <= kSame * scale + nothing)
        continue;
      result_.alternatives.push_back({other.energy, distance});
    }
    std::sort(result_.alternatives.begin(), result_.alternatives.end(),
              [](const Alternative& a, const Alternative& b) { return a.energy < b.energy; });
  }

  const Harness& harness_;
  const EquilibriumOptions& options_;
  Equilibrium& result_;
  bool conservative_ = true;
  Grid start_grid_;
  Refined best_;
  std::vector<Other> others_;
  Equilibrium first_failure_;
};

}  // namespace

std::unique_ptr<Branch> lowestOfStarts(const Harness& harness, const EquilibriumOptions& options,
                                       Equilibrium& result) {
  return LowestShape(harness, options, result).find();
}

std::unique_ptr<Branch> lowestShape(const Harness& harness, const EquilibriumOptions& options,
                                    Equilibrium& result) {
  std::unique_ptr<Branch> branch = lowestOfStarts(harness, options, result);
  if (branch || harness.contacts.empty() || result.status != EquilibriumStatus::not_converged) return branch;
  return ledOut(harness, options, result);
}

}  // namespace cable_variation
