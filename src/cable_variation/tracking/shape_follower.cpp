#include <cable_variation/tracking/shape_follower.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cable_variation {
namespace {

// Further from the first-order prediction than this is looked at step by step: a share of the motion
// expected, and of the cable's length. Curved paths of clips that turn by some 10 degrees stay below.
constexpr double kOddShare = 0.5, kOddOfLength = 0.01;
// A step that ends further from its prediction than this is cut; when it cannot be cut any more it is a jump.
constexpr double kStepShare = 0.3, kStepOfLength = 0.002;
constexpr double kFirstStep = 1.0 / 8.0, kSmallestStep = 1.0 / 512.0;
// Shapes on the way are kept if they are this far from the last one kept: a share of the cable's length.
constexpr double kWorthKeeping = 0.002;
constexpr int kMostSteps = 150;  // a jump takes some 30; a way of nothing but jumps is given up
// Closely followed, the shape is not expected to move further in one step: a share of the cable's length.
constexpr double kCloseStep = 0.02;
constexpr int kMostCloseSteps = 600;
// A path whose ends and middle fit together to this share of the motion is smooth.
constexpr double kSmoothShare = 0.1;

}  // namespace

ShapeFollower::ShapeFollower(const StretchReader& reader, EquilibriumSolver solver, const Harness& harness,
                             const Equilibrium& equilibrium, double reference_time)
    : reader_(&reader), solver_(std::move(solver)), reference_time_(reference_time) {
  reference_ = reader.readWithRates(reader.space().designAt(reference_time), harness, equilibrium, solver_);
  for (const Cable& cable : harness.cables) length_ = std::max(length_, cable.length);
}

void tellOf(const FollowedShape& followed, const ToleranceSpace& tolerances, const SolvedWitness& witness) {
  if (!witness || !followed.converged) return;
  witness(followed.shape.place, followed.harness, followed.equilibrium);
  if (!followed.jump) return;
  const FollowedShape::Jump& jump = *followed.jump;
  // the jump may be on the first step: then the side before it is the design's own shape
  if (jump.equilibrium_before.converged() && tolerances.contains(jump.before.place.deviations))
    witness(jump.before.place, jump.harness_before, jump.equilibrium_before);
  if (tolerances.contains(jump.after.place.deviations))
    witness(jump.after.place, jump.harness_after, jump.equilibrium_after);
}

FollowedShape ShapeFollower::follow(const SamplePlace& place, bool with_rates) const {
  FollowedShape followed;
  try {
    EquilibriumSolver solver = solver_;
    followed.harness = reader_->space().harness(place);
    followed.equilibrium = solver.update(followed.harness);
    if (!followed.equilibrium.converged()) return followInSteps(place, with_rates, Pace::usual);
    followed.shape = with_rates
                         ? reader_->readWithRates(place, followed.harness, followed.equilibrium, solver)
                         : reader_->read(place, followed.harness, followed.equilibrium);
  } catch (const std::invalid_argument& error) {
    followed.message = error.what();
    return followed;
  } catch (const OtherStations&) {
    return followInSteps(place, with_rates, Pace::usual);
  }
  const Eigen::Matrix3Xd expected = reference_.predicted(coordinates(place));
  const double odd = largestDistance(expected, followed.shape.ends[0]).distance;
  const double motion = largestDistance(expected, reference_.ends[0]).distance;
  if (odd > kOddShare * motion + kOddOfLength * length_) return followInSteps(place, with_rates, Pace::usual);
  followed.converged = true;
  return followed;
}

FollowedShape ShapeFollower::followClosely(const SamplePlace& place) const {
  return followInSteps(place, false, Pace::close);
}

double ShapeFollower::expectedMotion(const SamplePlace& place) const {
  const Eigen::Matrix3Xd expected = reference_.predicted(coordinates(place));
  return largestDistance(expected, reference_.ends[0]).distance / length_;
}

FollowedShape ShapeFollower::followWatchfully(const SamplePlace& place) const {
  FollowedShape followed;
  try {
    EquilibriumSolver solver = solver_;
    followed.harness = reader_->space().harness(place);
    followed.equilibrium = solver.update(followed.harness);
    if (!followed.equilibrium.converged()) return followClosely(place);
    followed.shape = reader_->readWithRates(place, followed.harness, followed.equilibrium, solver);
    if (!isSmoothTo(followed.shape, solver_)) return followClosely(place);
  } catch (const std::invalid_argument& error) {
    followed.message = error.what();
    return followed;
  } catch (const OtherStations&) {
    return followClosely(place);
  }
  followed.converged = true;
  followed.shape.rates.clear();
  return followed;
}

// With responses r at both ends of a smooth path x, x₁ - x₀ is (r₀ + r₁)/2 and x in the middle (x₀ + x₁)/2 +
// (r₀ - r₁)/8, but for derivatives of the third and the fourth order.
bool ShapeFollower::isSmoothTo(const StretchShape& there, const EquilibriumSolver& solver) const {
  const Eigen::VectorXd change = coordinates(there.place);
  const Eigen::Matrix3Xd start = reference_.ends[0], end = there.ends[0];
  const Eigen::Matrix3Xd from_start = reference_.predicted(change) - start;
  const Eigen::Matrix3Xd to_end = end - there.predicted(-change);
  const double allowed = kSmoothShare * largestDistance(start, end).distance + kStepOfLength * length_;
  if (largestDistance(end - start, 0.5 * (from_start + to_end)).distance > allowed) return false;
  const SamplePlace half{0.5 * there.place.deviations, 0.5 * (reference_time_ + there.place.time)};
  EquilibriumSolver middle = solver;
  const Harness harness = reader_->space().harness(half);
  const Equilibrium found = middle.update(harness);
  if (!found.converged()) return false;
  const StretchShape between = reader_->read(half, harness, found);
  return largestDistance(between.ends[0], 0.5 * (start + end) + 0.125 * (from_start - to_end)).distance <=
         allowed;
}

// The share of the way in which the shape is expected to move by no more than kCloseStep.
double ShapeFollower::closeStep(const StretchShape& here, const SamplePlace& from, const SamplePlace& end,
                                double left) const {
  const Eigen::Matrix3Xd expected = here.predicted(coordinates(end) - coordinates(from));
  const double motion = largestDistance(expected, here.ends[0]).distance;
  return motion > 0.0 ? left * kCloseStep * length_ / motion : left;
}

// Whether the shape that was found ahead comes back to the one it was to come from.
bool ShapeFollower::goesBack(const StretchShape& here, const SamplePlace& from,
                             EquilibriumSolver ahead) const {
  try {
    const Harness harness = reader_->space().harness(from);
    const Equilibrium back = ahead.update(harness);
    if (!back.converged()) return false;
    const StretchShape there = reader_->read(from, harness, back);
    return largestDistance(there.ends[0], here.ends[0]).distance < kStepOfLength * length_;
  } catch (const std::exception&) {
    return false;
  }
}

void ShapeFollower::keepOnTheWay(const StretchShape& shape, FollowedShape& followed) const {
  const StretchShape& last = followed.on_the_way.empty() ? reference_ : followed.on_the_way.back().shape;
  if (largestDistance(last.ends[0], shape.ends[0]).distance < kWorthKeeping * length_) return;
  followed.on_the_way.push_back({shape, followed.jump.has_value()});
}

FollowedShape ShapeFollower::followInSteps(const SamplePlace& place, bool with_rates, Pace pace) const {
  const bool close = pace == Pace::close;
  FollowedShape followed;
  EquilibriumSolver solver = solver_;
  StretchShape here = reference_;
  Harness harness_here;
  Equilibrium equilibrium_here;
  double reached = 0.0, step = close ? 1.0 : kFirstStep;
  const auto placeAt = [&](double share) {
    return SamplePlace{share * place.deviations, reference_time_ + share * (place.time - reference_time_)};
  };
  for (int tried = 0; reached < 1.0; ++tried) {
    if (close) {
      const double most = closeStep(here, placeAt(reached), place, 1.0 - reached);
      step = std::min(step, std::max(most, kSmallestStep));
    }
    if (tried == (close ? kMostCloseSteps : kMostSteps)) {
      followed.message =
          "the shape cannot be followed there: it is close to losing its stability all the way";
      return followed;
    }
    const double next = std::min(1.0, reached + step);
    EquilibriumSolver ahead = solver;
    StretchShape there;
    bool found = false;
    try {
      followed.harness = reader_->space().harness(placeAt(next));
      followed.equilibrium = ahead.update(followed.harness);
      found = followed.equilibrium.converged();
      if (found)
        there = reader_->readWithRates(placeAt(next), followed.harness, followed.equilibrium, ahead);
      else
        followed.message = followed.equilibrium.message;
    } catch (const std::exception& error) {
      followed.message = error.what();
      found = false;
    }
    if (!found) {
      if (step <= kSmallestStep) return followed;
      step *= 0.5;
      continue;
    }
    const Eigen::Matrix3Xd expected =
        here.predicted(coordinates(placeAt(next)) - coordinates(placeAt(reached)));
    const LargestDistance odd = largestDistance(expected, there.ends[0]);
    const double motion = largestDistance(expected, here.ends[0]).distance;
    if (odd.distance > kStepShare * motion + kStepOfLength * length_) {
      if (step > kSmallestStep) {
        step *= 0.5;
        continue;
      }
      const bool first = !close || (!followed.jump && !goesBack(here, placeAt(reached), ahead));
      // a prediction that is off alone, as beside a motion that costs nothing, is none
      const double gone = largestDistance(there.ends[0], here.ends[0]).distance;
      if (std::min(odd.distance, gone) > kOddOfLength * length_ && first) {
        for (auto& kept : followed.on_the_way) kept.beyond = false;
        followed.jump = {here,
                         there,
                         harness_here,
                         followed.harness,
                         equilibrium_here,
                         followed.equilibrium,
                         static_cast<std::size_t>(odd.column / 2),
                         std::min(odd.distance, gone)};
      }
    } else {
      step = close ? 2.0 * step : std::min(2.0 * step, kFirstStep);
    }
    solver = std::move(ahead);
    here = std::move(there);
    if (with_rates) keepOnTheWay(here, followed);
    harness_here = followed.harness;
    equilibrium_here = followed.equilibrium;
    reached = next;
  }
  followed.converged = true;
  followed.message.clear();
  if (!followed.jump) followed.on_the_way.clear();
  followed.shape = std::move(here);
  if (!with_rates) followed.shape.rates.clear();
  return followed;
}

}  // namespace cable_variation
