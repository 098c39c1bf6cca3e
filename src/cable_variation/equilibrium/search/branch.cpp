#include <cable_variation/equilibrium/search/branch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

#include <cable_variation/equilibrium/discretisation/contact_result.h>
#include <cable_variation/equilibrium/discretisation/equilibrium_result.h>
#include <cable_variation/equilibrium/search/smallest_eigenvalue.h>
#include <cable_variation/equilibrium/search/start_search.h>
#include <cable_variation/math/so3.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

// A harness goes to another one in pieces that turn no clip by more than this [rad].
constexpr double kLargestPiece = 0.35;
constexpr int kRefinements = 7;
// The layer in which a taut cable bends beside a clamp may be a ten-thousandth of its length.
constexpr int kRefinementsForForces = 14;

// The clips on their way from `from` to `to`.
Harness between(const Harness& from, const Harness& to, double t) {
  Harness harness = to;
  for (std::size_t i = 0; i < to.clips.size(); ++i) {
    Pose& pose = harness.clips[i].pose;
    const Pose& start = from.clips[i].pose;
    pose.position = (1.0 - t) * start.position + t * pose.position;
    pose.orientation = start.orientation.slerp(t, pose.orientation);
  }
  for (std::size_t i = 0; i < to.contacts.size(); ++i) {
    Pose& pose = harness.contacts[i].pose;
    const Pose& start = from.contacts[i].pose;
    pose.position = (1.0 - t) * start.position + t * pose.position;
    pose.orientation = start.orientation.slerp(t, pose.orientation);
  }
  return harness;
}

// With dead moments scaled by `share`.
Harness withMoments(const Harness& harness, double share) {
  Harness scaled = harness;
  for (PointLoad& load : scaled.loads) load.moment *= share;
  return scaled;
}

std::size_t elementsOf(const Grid& grid) {
  std::size_t count = 0;
  for (const auto& boundaries : grid) count += boundaries.size() - 1;
  return count;
}

// Whether the true tube is away from where it is pressed: its curve between the sections solved is not the
// element's.
bool pressesFromAfar(const Problem& problem, const std::vector<CableShape>& shapes) {
  const std::vector<ContactSystem::Pressing>& pressing = problem.system->contact()->pressing();
  return std::any_of(pressing.begin(), pressing.end(), [&](const ContactSystem::Pressing& at) {
    const Span& span = problem.topology.spans[at.span];
    const double left = problem.configuration.stations[span.left].arc_length;
    const double right = problem.configuration.stations[span.right].arc_length;
    const Eigen::Vector3d x = shapes[span.cable].position(left + at.share * (right - left));
    return at.gap + at.direction.dot(x - at.position) > kTouching;
  });
}

int piecesOf(double turn) { return std::max(1, static_cast<int>(std::ceil(turn / kLargestPiece))); }

}  // namespace

Branch::Branch(const Harness& harness, const EquilibriumOptions& options)
    : options_(options), problem_(harness) {
  problem_.setGrid(startGrid(problem_.harness, problem_.topology));
}

Branch::Branch(const Branch& other) = default;

// From the shape at hand to a minimum near by, or with `settle` to the stationary shape near by; roughly
// while stretch is softened.
bool Branch::descend(bool settle, StartStress stress, Equilibrium& result, int most_iterations) {
  const int iterations = std::min(options_.max_iterations, most_iterations);
  if (problem_.system->contact()) return descendInContact(settle, stress, iterations, result);
  const Minimum minimum = minimise(*problem_.system, problem_.configuration,
                                   {iterations, settle, stress, false, options_.descent});
  result.iterations += minimum.iterations;
  result.residual = minimum.residual;
  if (settle) unstable_ = !minimum.stable();
  return settle ? minimum.stationary() : minimum.stable();
}

// Descents with the forces of contact that are known, which then become those of the last; until no gap is
// closed. Where the next one does not get down, about a sharp edge, one that was nearly there will do.
bool Branch::descendInContact(bool settle, StartStress stress, int iterations, Equilibrium& result) {
  constexpr int kRounds = 60;
  constexpr int kPatience = 60;  // Newton steps, once one was nearly there
  constexpr int kTurn = 100;     // Newton steps, before what presses is looked at for edges to roll over
  constexpr double kNearly = 0.5 * kTouching;
  RodSystem& system = *problem_.system;
  ContactSystem& contact = *system.contact();
  if (contact.holds()) contact.soften(1.0);
  contact.letMove(problem_.configuration);
  std::optional<std::pair<Configuration, ContactSystem>> nearly;
  int left = iterations;
  for (int round = 0; round < kRounds; ++round) {
    const int most = std::min(left, nearly ? kPatience : kTurn);
    const Minimum minimum =
        minimise(system, problem_.configuration, {most, settle, stress, false, options_.descent});
    result.iterations += minimum.iterations;
    left -= minimum.iterations;
    const bool found = settle ? minimum.stationary() : minimum.stable();
    if (found) {
      result.residual = minimum.residual;
      if (settle) unstable_ = !minimum.stable();
      const bool closed = contact.findMinima(problem_.configuration);
      if (!closed && contact.worstGap() <= gap_tolerance_) return true;
      if (contact.worstGap() <= kNearly) nearly.emplace(problem_.configuration, contact);
      left = iterations;
    } else if (nearly) {
      problem_.configuration = nearly->first;
      contact.take(nearly->second);
      system.evaluate(problem_.configuration, RodSystem::Hessian::exact);
      return system.factorise(neutralShift(system), system.bendingMetric()) == 0;
    } else if (minimum.end == DescentEnd::most_iterations && left > 0) {
      contact.letMove(problem_.configuration);
      system.holdStress();
      stress = StartStress::held;
      continue;
    } else {
      result.residual = minimum.residual;
      return false;
    }
    contact.keepForces(problem_.configuration);
    contact.soften(1.0);
    system.holdStress();
    stress = StartStress::held;
  }
  result.message = "the forces of contact did not come to rest: a gap is still closed by " +
                   shortNumber(1e3 * contact.worstGap()) + " mm";
  return false;
}

void Branch::dropMoments() { problem_.harness = withMoments(problem_.harness, 0.0); }

bool Branch::letGo(Equilibrium& result) {
  problem_.system->soften(kSearchSlenderness, problem_.configuration);
  return descend(false, StartStress::own, result);
}

bool Branch::tighten(Equilibrium& result) {
  // At once where nothing slides, by this factor otherwise; then by smaller ones.
  constexpr double kGrowth = 100.0;
  constexpr double kSmallestGrowth = 2.0;
  constexpr int kIterations = 60;  // of a step that leads to the next shape
  RodSystem* system = problem_.system.get();
  if (!system->soften(kSearchSlenderness, problem_.configuration))
    return descend(unstable_, StartStress::own, result);
  // A coarse grid is too stiff for a slender rod, so the grid comes first; finely enough for the shape, which
  // is not yet quite the final one.
  constexpr double kRough = 1e-4;  // of the longest cable
  problem_.coarse->soften(kSearchSlenderness, problem_.configuration);
  system->evaluate(problem_.configuration, RodSystem::Hessian::none);
  softened_ = kSearchSlenderness;
  if (!adaptGrid(std::max(options_.accuracy, kRough * largestArcLength(problem_.configuration)), false,
                 result))
    return false;
  system = problem_.system.get();  // of the adapted grid: the one before is gone
  double growth = system->slides() ? kGrowth : INFINITY;
  while (system->soften(softened_, problem_.configuration)) {
    const Configuration softer = problem_.configuration;
    system->evaluate(problem_.configuration, RodSystem::Hessian::none);
    system->holdStress();
    const double before = std::exchange(softened_, softened_ * growth);
    if (!system->soften(softened_, problem_.configuration)) softened_ = INFINITY;
    if (descend(unstable_, StartStress::held, result, kIterations)) continue;
    softened_ = before;
    problem_.configuration = softer;
    growth = std::isfinite(growth) ? std::sqrt(growth) : kGrowth;
    if (growth < kSmallestGrowth) return false;
  }
  softened_ = INFINITY;
  problem_.coarse->soften(softened_, problem_.configuration);
  return true;
}

bool Branch::growMoments(const Harness& harness, Equilibrium& result) {
  double turn = 0.0;  // that the moments may cause [rad]
  for (const PointLoad& load : harness.loads) {
    const Section section = sectionAt(harness.cables[load.cable], load.arc_length);
    const double softest = std::min({section.EI_y, section.EI_z, section.GJ});
    turn += load.moment.norm() * harness.cables[load.cable].length / softest;
  }
  const int pieces = piecesOf(turn);
  bool passed_singular = false;
  for (int k = 1; k <= pieces; ++k) {
    carryTo(withMoments(harness, static_cast<double>(k) / pieces), makeTopology(harness));
    if (!descend(true, StartStress::held, result)) {
      result.status = EquilibriumStatus::not_converged;
      result.message =
          "the shape was lost while the dead moments grew: " +
          whereItFailed(problem_.harness, problem_.topology, *problem_.system, problem_.configuration);
      return false;
    }
    passed_singular = passed_singular || unstable_;
  }
  unstable_ = passed_singular;
  return true;
}

// The shape and its section forces are carried over. Returns what was there before.
Branch::OnGrid Branch::regrid(const Grid& grid, const std::vector<CableShape>& shapes) {
  OnGrid before{std::move(problem_.system), std::move(problem_.coarse), std::move(problem_.configuration)};
  before.system->holdStress();
  problem_.setGrid(grid);
  problem_.system->takeStress(*before.system);
  problem_.system->takeContacts(*before.system);
  problem_.configuration = onGrid(problem_.topology, before.configuration, shapes, problem_.system->grid());
  problem_.system->soften(softened_, problem_.configuration);
  problem_.coarse->soften(softened_, problem_.configuration);
  return before;
}

// A harness on the way may need a finer grid than those after it: to stay on it would slow all of them down
// for good, so that the grid that following began with is tried again. The shape at hand must be the same
// there.
void Branch::returnToGrid() {
  constexpr int kLongest = 64;             // that the finer grid is kept before the next try, in harnesses
  constexpr double kSameShape = 10.0;      // what the shape may move by, of the accuracy
  if (problem_.system->contact()) return;  // where it touches needs a fine grid all along
  const Grid& grid = problem_.system->grid();
  if (first_grid_.empty()) first_grid_ = grid;
  if (elementsOf(grid) <= elementsOf(first_grid_)) {
    keep_ = std::max(1, keep_ / 2);
    left_ = 0;
    return;
  }
  if (left_ == 0) {
    left_ = keep_;
    keep_ = std::min(2 * keep_, kLongest);
  }
  if (--left_ > 0 || unstable_) return;
  const std::vector<CableShape> shapes =
      describeShapes(problem_.harness, problem_.topology, *problem_.system, problem_.configuration);
  OnGrid fine = regrid(first_grid_, shapes);
  const Configuration before = problem_.configuration;
  Equilibrium cost;
  if (descend(false, StartStress::held, cost) &&
      largestDistance(first_grid_, before, first_grid_, problem_.configuration) <=
          kSameShape * options_.accuracy)
    return;
  restoreGrid(std::move(fine));
  problem_.system->evaluate(problem_.configuration, RodSystem::Hessian::exact);
  problem_.system->factorise(neutralShift(*problem_.system), problem_.system->bendingMetric());
}

void Branch::restoreGrid(OnGrid before) {
  problem_.system = std::move(before.system);
  problem_.coarse = std::move(before.coarse);
  problem_.configuration = std::move(before.configuration);
}

// The pairs of elements with most of the error in energy: of all, and of each cable whose forces or
// directions are not yet right. What is split does not depend on the accuracy of the centreline, so that a
// grid for half of it is one for the whole, refined.
std::vector<std::vector<bool>> Branch::pairsThatMatter(const DiscretisationError& error, bool forces) const {
  constexpr double kMatters = 0.02;  // of the largest
  std::vector<double> largest(problem_.harness.cables.size(), 0.0);
  for (std::size_t i = 0; i < error.contribution.size(); ++i) {
    double& of = largest[problem_.topology.spans[i].cable];
    for (double c : error.contribution[i]) of = std::max(of, c);
  }
  const double largest_of_all = *std::max_element(largest.begin(), largest.end());
  std::vector<std::vector<bool>> marked;
  for (std::size_t i = 0; i < error.contribution.size(); ++i) {
    const std::size_t cable = problem_.topology.spans[i].cable;
    const bool own = forces && error.force[cable] > options_.force_accuracy;
    const double from = kMatters * (own ? largest[cable] : largest_of_all);
    marked.emplace_back();
    for (double c : error.contribution[i])
      marked.back().push_back(c >= from || !std::isfinite(error.centreline));
  }
  return marked;
}

// By the exact distance, which is the costlier the more of a cable lies flat: once for a shape.
ExactGap Branch::exactGapOf(const std::vector<CableShape>& shapes) {
  const std::vector<SpanConfiguration>& spans = problem_.configuration.spans;
  const auto same = [](const SpanConfiguration& a, const SpanConfiguration& b) {
    return a.positions == b.positions && a.orientations.size() == b.orientations.size() &&
           std::equal(a.orientations.begin(), a.orientations.end(), b.orientations.begin(),
                      [](const auto& p, const auto& q) { return p.coeffs() == q.coeffs(); });
  };
  if (!known_gap_ ||
      !std::equal(spans.begin(), spans.end(), known_gap_->spans.begin(), known_gap_->spans.end(), same))
    known_gap_ =
        GapAt{spans, exactGap(problem_.harness, *problem_.system->contact(), problem_.configuration, shapes)};
  return known_gap_->gap;
}

// Whether the true tubes enter no part that they have contact with, or the place is watched from now on; and
// are where parts press them.
bool Branch::isClear(const Equilibrium& result) {
  if (!problem_.system->contact()) return true;
  ContactSystem& contact = *problem_.system->contact();
  const ExactGap exact = exactGapOf(result.shapes);
  if (exact.gap >= -kTouching) return !pressesFromAfar(problem_, result.shapes);
  contact.watch(problem_.harness.contacts[exact.contact].cable, exact.arc_length, problem_.configuration);
  return false;
}

bool Branch::adaptGrid(Equilibrium& result) { return adaptGrid(options_.accuracy, true, result); }

bool Branch::adaptGrid(double accuracy, bool forces, Equilibrium& result) {
  // An error below so many times what is allowed gets smaller by half within so many refinements, or is
  // rounding.
  constexpr double kResolved = 20.0, kSmaller = 0.5;
  constexpr int kPatience = 3;
  OnGrid before;
  double best = INFINITY;
  int best_round = 0;
  const int most_rounds = forces ? kRefinementsForForces : kRefinements;
  for (int round = 0;; ++round) {
    result.shapes =
        describeShapes(problem_.harness, problem_.topology, *problem_.system, problem_.configuration);
    const Configuration on_coarse =
        onGrid(problem_.topology, problem_.configuration, result.shapes, problem_.coarse->grid());
    problem_.coarse->freezeContacts(*problem_.system);
    const DiscretisationError error =
        estimateDiscretisation(*problem_.system, *problem_.coarse, on_coarse, !unstable_);
    result.discretisation_error = error.centreline;
    force_error_ = *std::max_element(error.force.begin(), error.force.end());
    const double excess = force_error_ / options_.force_accuracy;
    if (excess < kSmaller * best) {
      best = excess;
      best_round = round;
    }
    const bool clear = isClear(result);
    if (error.centreline <= accuracy && clear) {
      const bool rounding = excess < kResolved && round - best_round >= kPatience;
      if (!forces || unstable_ || excess <= 1.0 || rounding || round == most_rounds) return true;
    } else if (round >= most_rounds) {
      break;
    }
    before = regrid(refine(problem_.system->grid(), pairsThatMatter(error, forces)), result.shapes);
    if (descend(unstable_ || !problem_.system->conservative(), StartStress::held, result)) continue;
    if (!(error.centreline <= accuracy) || !clear) break;
    restoreGrid(std::move(before));  // leaves it as good as it was
    problem_.system->evaluate(problem_.configuration, RodSystem::Hessian::none);
    return true;
  }
  result.shapes.clear();
  return false;
}

bool Branch::overstretched(Equilibrium& result) const {
  for (const CableShape& shape : result.shapes) {
    for (const ShapePoint& point : shape.points) {
      const double strain = point.strain.x();
      if (std::abs(strain) <= 2.0 * kLargestStretch) continue;
      std::ostringstream text;
      text << "cable '" << shape.cable << "' is " << (strain > 0.0 ? "stretched" : "compressed") << " by "
           << 100.0 * std::abs(strain) << " % at " << 1e3 * point.arc_length << " mm; expected at most "
           << 200.0 * kLargestStretch << " %: "
           << (strain > 0.0
                   ? "what holds or loads it there leaves it too little length"
                   : "what holds or loads it there presses it together, and it is too short and thick "
                     "there to bow out");
      result.status = EquilibriumStatus::impossible;
      result.message = text.str();
      return true;
    }
  }
  return false;
}

void Branch::letPointsMove() {
  RodSystem& system = *problem_.system;
  const Configuration before = problem_.configuration;
  const ContactSystem known = *system.contact();
  constexpr double kClosed = 1e-3;
  const bool moved = system.contact()->letPointsMove(problem_.configuration);
  const std::vector<ContactSystem::Pressing>& pressing = system.contact()->pressing();
  // many that are held find that only in the long run
  const bool all_move = std::all_of(pressing.begin(), pressing.end(),
                                    [](const ContactSystem::Pressing& at) { return at.sharpness > 0.0; });
  if (all_move) gap_tolerance_ = kClosed * kGapTolerance;
  if (moved || system.contact()->worstGap() > gap_tolerance_) {
    system.evaluate(problem_.configuration, RodSystem::Hessian::none);
    system.holdStress();
    Equilibrium cost;
    if (!descend(unstable_, StartStress::held, cost)) {
      problem_.configuration = before;
      system.contact()->take(known);
    }
  }
  system.evaluate(problem_.configuration, RodSystem::Hessian::exact);
}

// Known where what presses does so at sharp minima, which move, or at ends of cables. Of a blunt minimum the
// elements know the second derivative too badly, and of a stretch that lies flat where it ends.
double Branch::eigenvalueInContact() const {
  const std::vector<ContactSystem::Pressing>& pressing = problem_.system->contact()->pressing();
  const bool known = std::all_of(pressing.begin(), pressing.end(), [](const ContactSystem::Pressing& at) {
    return at.sharpness > 0.0 || at.share <= 0.0 || at.share >= 1.0;
  });
  if (!known) return std::numeric_limits<double>::quiet_NaN();
  Branch aside(*this);
  aside.letPointsMove();
  RodSystem& system = *aside.problem_.system;
  system.evaluate(aside.problem_.configuration, RodSystem::Hessian::exact);
  return smallestEigenvalueInContact(system, aside.problem_.configuration);
}

// A shape that is right on a grid which its softest motion is too fine for, as a straight twisted one is,
// gets its grid refined for that. Neutral motions are no matter of grids.
void Branch::findEigenvalue(Equilibrium& result) {
  constexpr double kOfBending = 1e-3;
  constexpr double kOrderFour = 15.0;
  for (int round = 0;; ++round) {
    RodSystem& system = *problem_.system;
    RodSystem& coarse = *problem_.coarse;
    system.evaluate(problem_.configuration, RodSystem::Hessian::exact);
    if (system.contact() && !system.contact()->pressing().empty()) {
      result.smallest_eigenvalue = eigenvalueInContact();
      return;
    }
    const SoftestMotion softest = softestMotion(system, problem_.configuration);
    const std::string neutral = neutralText(softest, system, problem_.configuration);
    result.smallest_eigenvalue = softest.eigenvalue;
    if (unstable_ || !system.conservative()) return;
    // It was judged stable by the signs of pivots, to a small share of what bends the cables. What is
    // negative by more than it is known to may be a saddle all the same, as of a light branch that stands
    // upright.
    const double floor = options_.eigenvalue_accuracy * kOfBending * softestBending(system);
    if (softest.eigenvalue < -floor) {
      if (leaveSaddle(softest.motion, result)) {
        round = 0;
        continue;
      }
      std::ostringstream text;
      text
          << "the smallest eigenvalue is " << softest.eigenvalue
          << " N/m, below 0 by less than stability is judged by: it may be a saddle, though no shape of less "
             "energy was found beside it";
      result.notes.push_back(text.str());
      if (!neutral.empty()) result.notes.push_back(neutral);
      return;
    }
    result.smallest_eigenvalue = std::max(result.smallest_eigenvalue, 0.0);
    const Configuration on_coarse =
        onGrid(problem_.topology, problem_.configuration, result.shapes, coarse.grid());
    const DiscretisationError error = estimateDiscretisation(system, coarse, on_coarse, false);
    Configuration there = on_coarse;
    coarse.move(error.step, there);
    coarse.evaluate(there, RodSystem::Hessian::exact);
    const double on_merged = smallestEigenvalueBeside(softest, coarse, there);
    const double allowed = options_.eigenvalue_accuracy * std::max(std::abs(result.smallest_eigenvalue),
                                                                   kOfBending * softestBending(system));
    const bool known = std::abs(on_merged - result.smallest_eigenvalue) <= kOrderFour * allowed;
    if (known || round == kRefinements) {
      if (!neutral.empty()) result.notes.push_back(neutral);
      return;
    }
    std::vector<std::vector<bool>> all;
    for (std::size_t i = 0; i < coarse.grid().size(); ++i) all.emplace_back(coarse.elementCount(i), true);
    OnGrid before = regrid(refine(system.grid(), all), result.shapes);
    if (!descend(false, StartStress::held, result)) {  // leaves it as good as it was
      restoreGrid(std::move(before));
      if (!neutral.empty()) result.notes.push_back(neutral);
      return;
    }
    result.shapes =
        describeShapes(problem_.harness, problem_.topology, *problem_.system, problem_.configuration);
  }
}

// Down along a motion of negative stiffness, either way, to a shape of less energy. Whether there is one,
// this often.
bool Branch::leaveSaddle(const NodalField& motion, Equilibrium& result) {
  constexpr double kPushes[] = {0.05, -0.05, 0.5, -0.5};  // [rad]
  constexpr int kMost = 4;
  RodSystem& system = *problem_.system;
  const Configuration saddle = problem_.configuration;
  const double before = system.energy().total();
  double rotation = 0.0;
  for (const auto& nodes : motion.spans)
    rotation = std::max(rotation, nodes.bottomRows<3>().colwise().norm().maxCoeff());
  for (const double push : kPushes) {
    if (left_saddles_ >= kMost || !(rotation > 0.0)) break;
    NodalField step = motion;
    step.scale(push / rotation);
    system.evaluate(saddle, RodSystem::Hessian::exact);
    if (system.contact() && system.contact()->freeShare(saddle, step) < 1.0) continue;
    problem_.configuration = saddle;
    system.predictStress(step);
    system.move(step, problem_.configuration);
    if (!system.arcLengthsInOrder(problem_.configuration)) continue;
    if (!descend(false, StartStress::held, result)) continue;
    system.evaluate(problem_.configuration, RodSystem::Hessian::none);
    if (system.energy().total() < before && adaptGrid(result)) {
      ++left_saddles_;
      return true;
    }
    if (problem_.system.get() != &system) return false;  // on another grid already
  }
  problem_.configuration = saddle;
  system.evaluate(saddle, RodSystem::Hessian::exact);
  return false;
}

// Far from the origin positions are rounded by what would stretch a slender cable noticeably.
bool Branch::lostInRounding(Equilibrium& result) const {
  constexpr double kMost = 0.3;  // of RodSystem::stiffnessNoise(); 0.1 is seen in forces, by a hundredth
  if (problem_.system->stiffnessNoise() <= kMost) return false;
  double reach = 0.0;
  for (const Clip& clip : problem_.harness.clips) reach = std::max(reach, clip.pose.position.norm());
  std::ostringstream text;
  text << "the clips lie up to " << reach << " m from the origin, where positions are rounded by "
       << 2e-16 * reach
       << " m: too much for cables as slender as these; expected the scene's origin near the harness";
  result.status = EquilibriumStatus::not_converged;
  result.message = text.str();
  result.shapes.clear();
  return true;
}

void Branch::noteForces(Equilibrium& result) const {
  if (unstable_) return;
  if (force_error_ <= options_.force_accuracy) return;
  std::ostringstream text;
  text << "forces and moments at clips, joints and loads are known to " << force_error_
       << " of the largest in their cable only, instead of " << options_.force_accuracy;
  result.notes.push_back(text.str());
}

// Whether it is one: no tube enters a part.
bool Branch::describeContact(Equilibrium& result) {
  const ContactSystem& contact = *problem_.system->contact();
  result.contacts = describeContacts(problem_.harness, problem_.topology, contact, problem_.configuration,
                                     options_.accuracy);
  const ExactGap exact = exactGapOf(result.shapes);
  result.smallest_gap = exact.gap;
  if (exact.gap >= -kTouching) return true;
  const PartContact& of = problem_.harness.contacts[exact.contact];
  std::ostringstream text;
  text << "cable '" << problem_.harness.cables[of.cable].name << "' enters part '" << of.part << "' by "
       << -1e3 * exact.gap << " mm at " << 1e3 * exact.arc_length
       << " mm, where it should touch it; expected a start outside, via points that lead there";
  result.status = EquilibriumStatus::not_converged;
  result.message = text.str();
  result.shapes.clear();
  result.contacts.clear();
  return false;
}

void Branch::finish(Equilibrium& result) {
  left_saddles_ = 0;
  if (lostInRounding(result)) return;
  if (options_.eigenvalue || unstable_) findEigenvalue(result);
  describe(problem_.harness, problem_.topology, *problem_.system, problem_.configuration, result);
  if (overstretched(result)) return;
  if (problem_.system->contact() && !describeContact(result)) return;
  result.status = EquilibriumStatus::converged;
  noteForces(result);
  if (unstable_) {
    std::ostringstream text;
    text << "the only equilibrium found is unstable";
    if (!std::isnan(result.smallest_eigenvalue))
      text << ": the smallest eigenvalue is " << result.smallest_eigenvalue << " N/m";
    result.status = EquilibriumStatus::unstable;
    result.message = text.str();
  }
}

// Carries the shape along to the new harness, to first order, and predicts its section forces.
void Branch::carryTo(const Harness& harness, Topology topology) {
  Configuration& configuration = problem_.configuration;
  const std::vector<StationConfiguration> before = configuration.stations;
  known_gap_.reset();
  problem_.harness = harness;
  problem_.topology = std::move(topology);
  for (std::size_t i = 0; i < configuration.stations.size(); ++i) {
    if (problem_.system->unknowns().slide(i) < 0) {
      configuration.stations[i].arc_length = problem_.topology.stations[i].arc_length;
    }
  }
  placeStations(problem_.harness, problem_.topology, configuration);
  Eigen::Matrix<double, 6, Eigen::Dynamic> carried(6,
                                                   static_cast<Eigen::Index>(configuration.stations.size()));
  bool moved = false;
  for (std::size_t i = 0; i < configuration.stations.size(); ++i) {
    const Pose& from = before[i].pose;
    const Pose& to = configuration.stations[i].pose;
    carried.col(static_cast<Eigen::Index>(i)) << to.position - from.position,
        so3::log(from.orientation.conjugate() * to.orientation);
    moved = moved || !carried.col(static_cast<Eigen::Index>(i)).isZero(0.0);
  }
  if (moved) {
    NodalField motion;
    problem_.system->follow(carried, motion);
    problem_.system->predictStress(motion);
    problem_.system->move(motion, configuration);
  } else {
    problem_.system->holdStress();
  }
  problem_.system->harnessChanged();
  problem_.coarse->harnessChanged();
}

// Pieces are halved where a cable would pass through a part.
bool Branch::followInContact(const Harness& harness, const Topology& topology, int pieces,
                             Equilibrium& result) {
  constexpr double kShortest = 1.0 / 1024.0, kGrowth = 1.5;
  const Harness origin = problem_.harness;
  double gone = 0.0, piece = 1.0 / pieces;
  while (gone < 1.0) {
    const double next = gone + piece > 1.0 - 1e-9 ? 1.0 : gone + piece;
    const Harness here = problem_.harness;
    const Topology topology_here = problem_.topology;
    const Configuration configuration = problem_.configuration;
    const ContactSystem known = *problem_.system->contact();
    carryTo(next < 1.0 ? between(origin, harness, next) : harness, topology);
    if (problem_.system->contact()->isFree(here.contacts, configuration, problem_.configuration) &&
        descend(false, StartStress::held, result)) {
      gone = next;
      piece *= kGrowth;
      continue;
    }
    piece *= 0.5;
    if (piece < kShortest) return false;
    problem_.harness = here;
    problem_.topology = topology_here;
    problem_.configuration = configuration;
    problem_.system->harnessChanged();
    problem_.coarse->harnessChanged();
    problem_.system->contact()->take(known);
    problem_.system->evaluate(problem_.configuration, RodSystem::Hessian::exact);
    problem_.system->factorise(neutralShift(*problem_.system), problem_.system->bendingMetric());
  }
  return true;
}

bool Branch::follow(const Harness& harness, const Topology& topology, Equilibrium& result) {
  returnToGrid();
  double turn = 0.0;
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const auto& from = problem_.harness.clips[i].pose.orientation;
    turn = std::max(turn, from.angularDistance(harness.clips[i].pose.orientation));
  }
  const int pieces = piecesOf(turn);
  if (problem_.system->contact())
    return followInContact(harness, topology, pieces, result) && adaptGrid(result);
  if (pieces > 1) {
    const Harness origin = problem_.harness;
    for (int k = 1; k < pieces; ++k) {
      carryTo(between(origin, harness, static_cast<double>(k) / pieces), topology);
      if (!descend(false, StartStress::held, result)) return false;
    }
  }
  carryTo(harness, topology);
  const bool reachable =
      unreachable(problem_.harness, problem_.topology, problem_.configuration, kLargestStretch).empty();
  return reachable && descend(false, StartStress::held, result) && adaptGrid(result);
}

}  // namespace cable_variation
