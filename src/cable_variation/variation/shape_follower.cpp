#include <cable_variation/variation/shape_follower.h>

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
constexpr int kMostSteps = 150;  // a jump takes some 30; a way of nothing but jumps is given up

}  // namespace

ShapeFollower::ShapeFollower(const StretchReader& reader, EquilibriumSolver solver, const Harness& harness,
                             const Equilibrium& equilibrium, double reference_time)
    : reader_(&reader), solver_(std::move(solver)), reference_time_(reference_time) {
  reference_ = reader.readWithRates(reader.space().designAt(reference_time), harness, equilibrium, solver_);
  for (const Cable& cable : harness.cables) length_ = std::max(length_, cable.length);
}

FollowedShape ShapeFollower::follow(const SamplePlace& place, bool with_rates) const {
  FollowedShape followed;
  try {
    EquilibriumSolver solver = solver_;
    followed.harness = reader_->space().harness(place);
    followed.equilibrium = solver.update(followed.harness);
    if (!followed.equilibrium.converged()) return followInSteps(place, with_rates);
    followed.shape = with_rates
                         ? reader_->readWithRates(place, followed.harness, followed.equilibrium, solver)
                         : reader_->read(place, followed.harness, followed.equilibrium);
  } catch (const std::invalid_argument& error) {
    followed.message = error.what();
    return followed;
  } catch (const std::runtime_error&) {
    return followInSteps(place, with_rates);
  }
  const Eigen::Matrix3Xd expected = reference_.predicted(coordinates(place));
  const double odd = largestDistance(expected, followed.shape.ends[0]).distance;
  const double motion = largestDistance(expected, reference_.ends[0]).distance;
  if (odd > kOddShare * motion + kOddOfLength * length_) return followInSteps(place, with_rates);
  followed.converged = true;
  return followed;
}

FollowedShape ShapeFollower::followInSteps(const SamplePlace& place, bool with_rates) const {
  FollowedShape followed;
  EquilibriumSolver solver = solver_;
  StretchShape here = reference_;
  double reached = 0.0, step = kFirstStep;
  const auto placeAt = [&](double share) {
    return SamplePlace{share * place.deviations, reference_time_ + share * (place.time - reference_time_)};
  };
  for (int tried = 0; reached < 1.0; ++tried) {
    if (tried == kMostSteps) {
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
      if (odd.distance > kOddOfLength * length_) {
        followed.jump = {here, there, static_cast<std::size_t>(odd.column / 2), odd.distance};
      }
    } else {
      step = std::min(2.0 * step, kFirstStep);
    }
    solver = std::move(ahead);
    here = std::move(there);
    reached = next;
  }
  followed.converged = true;
  followed.message.clear();
  followed.shape = std::move(here);
  if (!with_rates) followed.shape.rates.clear();
  return followed;
}

}  // namespace cable_variation
