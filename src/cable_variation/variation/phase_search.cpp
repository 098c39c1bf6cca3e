#include <cable_variation/variation/phase_search.h>

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace cable_variation {
namespace {

constexpr std::size_t kShapesPerRound = 128;
constexpr double kSharp = 0.87;  // cosine between the normals of facets that meet at a sharp edge: 30 degrees
// Derivatives that reach so many times as far as those of the reference belong to a shape about to snap.
constexpr double kAboutToSnap = 4.0;
// Derivatives that miss by this share of the motion lead astray; believed for less than so much, not at all.
constexpr double kAstray = 0.3, kLeastTrust = 0.1;
// Points that stick out of a hull by less than this share of the tolerance, or this length [m], are not taken
// in: pieces are rounded by as much more.
constexpr double kSlack = 0.2, kLeastSlack = 2e-6;
constexpr int kSteps = 32;  // that deviations are told apart by, over a tolerance

// The faces, edges and corners of a cube.
std::vector<Eigen::Vector3d> firstDirections() {
  std::vector<Eigen::Vector3d> directions;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) directions.push_back(Eigen::Vector3d(x, y, z).normalized());
      }
    }
  }
  return directions;
}

// Half the range of each coordinate: of the variables, then of the poses, one a row.
Eigen::VectorXd halfRanges(const ToleranceSpace& tolerances, const Eigen::MatrixXd& poses) {
  Eigen::VectorXd ranges(tolerances.size() + poses.cols());
  ranges.head(tolerances.size()) = 0.5 * (tolerances.upper() - tolerances.lower());
  for (Eigen::Index i = 0; i < poses.cols(); ++i) {
    constexpr double kStill = 1e-9;
    ranges[tolerances.size() + i] = std::max(kStill, poses.col(i).cwiseAbs().maxCoeff());
  }
  return ranges;
}

}  // namespace

PhaseSearch::PhaseSearch(ShapeFollower follower, std::vector<double> times, double tolerance)
    : follower_(std::move(follower)),
      times_(std::move(times)),
      first_tolerance_(tolerance),
      tolerance_(tolerance),
      slack_(std::max(kLeastSlack, kSlack * tolerance)) {
  const SampleSpace& space = follower_.reader().space();
  const Eigen::Index variables = space.tolerances().size();
  const Eigen::Index others = space.coordinates() - variables;
  poses_.resize(static_cast<Eigen::Index>(times_.size()), others);
  for (std::size_t i = 0; i < times_.size(); ++i) {
    poses_.row(static_cast<Eigen::Index>(i)) =
        follower_.coordinates(space.designAt(times_[i])).tail(others).transpose();
  }
  widths_ = halfRanges(space.tolerances(), poses_);
  branches_.emplace_back();
  radius_.assign(follower_.reader().stretches().size(), 0.0);
  own_radius_ = radius_;
  reach_ = largestReach(follower_.reference());
  insert(follower_.reference(), 0);
  rebuild();
}

void PhaseSearch::insert(const StretchShape& shape, std::size_t branch) {
  Branch& of = branches_[branch];
  if (of.hulls.empty()) {
    of.hulls.assign(shape.control.size(), std::vector<GrowingHull>(radius_.size()));
    of.first_ends = shape.ends[0];
  }
  const auto sample = static_cast<std::uint32_t>(samples_.size());
  for (std::size_t frame = 0; frame < shape.control.size(); ++frame) {
    for (std::size_t i = 0; i < radius_.size(); ++i) {
      const auto& points = shape.control[frame][i];
      for (std::size_t k = 0; k < points.size(); ++k) {
        const float share = static_cast<float>(k) / static_cast<float>(points.size() - 1);
        gained_ = std::max(gained_, of.hulls[frame][i].add(points[k], {sample, share}, slack_));
      }
    }
  }
  for (std::size_t i = 0; i < radius_.size(); ++i) {
    own_radius_[i] = std::max(own_radius_[i], shape.radius[i]);
  }
  updateRadius();
  discretisation_error_ = std::max(discretisation_error_, shape.discretisation_error);
  samples_.push_back(shape);
  samples_.back().control.clear();
  sample_coordinates_.push_back(follower_.coordinates(shape.place));
  sample_branch_.push_back(branch);
  trust_.push_back(largestReach(shape) <= kAboutToSnap * reach_ ? 1.0 : 0.0);
}

void PhaseSearch::updateRadius() {
  for (std::size_t i = 0; i < radius_.size(); ++i)
    radius_[i] = own_radius_[i] + slack_ + 2.0 * (tolerance_ - first_tolerance_);
}

// The furthest that all coordinates together (root sum of squares) move an end, by the derivatives [m].
double PhaseSearch::largestReach(const StretchShape& shape) const {
  const Eigen::VectorXf squares = widths_.array().square().cast<float>();
  const Eigen::Matrix4Xf& rates = shape.rates[0];
  double largest = 0.0;
  for (Eigen::Index first = 0; first < rates.cols(); first += squares.size()) {
    const auto of_end = rates.topRows<3>().middleCols(first, squares.size());
    largest = std::max<double>(largest, of_end.colwise().squaredNorm().dot(squares));
  }
  return std::sqrt(largest);
}

void PhaseSearch::rebuild() {
  const std::size_t frames = follower_.reader().frames().size(), stretches = radius_.size();
  tbb::parallel_for(std::size_t{0}, branches_.size() * frames * stretches, [&](std::size_t index) {
    branches_[index / (frames * stretches)].hulls[index / stretches % frames][index % stretches].rebuild();
  });
}

// From a shape on the facet on: its own derivatives, with the curvature that all shapes together tell.
void PhaseSearch::considerPush(const GrowingHull::Tag& tag, std::size_t frame, std::size_t stretch,
                               const Eigen::Vector3d& outward, Scratch& scratch,
                               std::vector<Push>& pushes) const {
  const double trust = trust_[tag.sample];
  if (trust < kLeastTrust) return;
  const SampleSpace& space = follower_.reader().space();
  const Eigen::Index variables = space.tolerances().size(), coordinates = space.coordinates();
  const Eigen::Vector4f along = (Eigen::Vector4f() << outward.cast<float>(), 1.0F).finished();
  const StretchShape& sample = samples_[tag.sample];
  const Eigen::Matrix4Xf rates = (1.0F - tag.share) * sample.endRates(frame, 2 * stretch, coordinates) +
                                 tag.share * sample.endRates(frame, 2 * stretch + 1, coordinates);
  scratch.gradient.noalias() = (along.transpose() * rates).transpose().cast<double>();
  const Eigen::VectorXd& here = sample_coordinates_[tag.sample];

  // the linear bound tells most facets off
  double most = 0.0;
  scratch.step.setZero(coordinates);
  for (Eigen::Index i = 0; i < variables; ++i) {
    const double slope = scratch.gradient[i];
    const double limit = slope > 0.0 ? space.tolerances().upper()[i] : space.tolerances().lower()[i];
    scratch.step[i] = limit - here[i];
    most += slope * scratch.step[i];
  }
  std::size_t pose = 0;
  if (coordinates > variables) {
    Eigen::Index best = 0;
    const auto slopes = scratch.gradient.tail(coordinates - variables);
    scratch.heights.noalias() = poses_ * slopes;
    most += scratch.heights.maxCoeff(&best) - slopes.dot(here.tail(coordinates - variables));
    pose = static_cast<std::size_t>(best);
    scratch.step.tail(coordinates - variables) =
        poses_.row(best).transpose() - here.tail(coordinates - variables);
  }
  if (most <= tolerance_) return;

  if (curvature_.empty()) {
    scratch.bend.setZero(coordinates, coordinates);
  } else {
    curvature_.along(frame, 2 * stretch + (tag.share < 0.5F ? 0 : 1), along, scratch.bend);
  }
  climb(here, scratch);
  scratch.step.head(variables) *= trust;
  const double gain =
      scratch.step.dot(scratch.gradient) + 0.5 * scratch.step.dot(scratch.bend.cast<double>() * scratch.step);
  if (gain <= tolerance_) return;
  Push push{tag.sample, scratch.gradient, here.head(variables) + scratch.step.head(variables), pose, gain};
  if (looked_at_.count(key({push.sample, push.target, push.pose})) == 0) pushes.push_back(std::move(push));
}

// Improves the step of the variables: one after the other is put where the height along it is largest.
void PhaseSearch::climb(const Eigen::VectorXd& here, Scratch& scratch) const {
  const ToleranceSpace& tolerances = follower_.reader().space().tolerances();
  const Eigen::Index variables = tolerances.size();
  constexpr int kSweeps = 3;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (Eigen::Index i = 0; i < variables; ++i) {
      if (!tolerances.isInterval(i)) continue;
      const double bend = scratch.bend(i, i);
      const double slope = scratch.gradient[i] + scratch.bend.col(i).cast<double>().dot(scratch.step) -
                           bend * scratch.step[i];  // at no step along i
      const double low = tolerances.lower()[i] - here[i], high = tolerances.upper()[i] - here[i];
      const auto height = [&](double step) { return step * (slope + 0.5 * bend * step); };
      double best = height(high) > height(low) ? high : low;
      if (bend < 0.0) best = std::clamp(-slope / bend, low, high);
      scratch.step[i] = best;
    }
    if (tolerances.hasRegions()) {
      const Eigen::VectorXd slopes = scratch.gradient + scratch.bend.cast<double>() * scratch.step;
      const Eigen::VectorXd far = tolerances.farthest(slopes.head(variables), here.head(variables));
      for (Eigen::Index i = 0; i < variables; ++i) {
        if (!tolerances.isInterval(i)) scratch.step[i] = far[i] - here[i];
      }
    }
  }
}

std::vector<PhaseSearch::Push> PhaseSearch::pushes() const {
  const std::size_t frames = follower_.reader().frames().size(), stretches = radius_.size();
  const std::size_t sets = branches_.size() * frames * stretches;
  std::vector<std::vector<Push>> found(sets);
  const std::vector<Eigen::Vector3d> first = firstDirections();
  tbb::parallel_for(std::size_t{0}, sets, [&](std::size_t index) {
    const std::size_t frame = index / stretches % frames, stretch = index % stretches;
    const GrowingHull& growing = branches_[index / (frames * stretches)].hulls[frame][stretch];
    if (growing.empty()) return;
    Scratch scratch;
    const ConvexHull& hull = growing.hull();
    const auto& triangles = hull.surface().triangles;
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
      const Eigen::Vector3d outward = hull.planes().col(static_cast<Eigen::Index>(triangle)).head<3>();
      for (std::size_t side = 0; side < 3; ++side) {
        const GrowingHull::Tag& tag = growing.tags()[triangles[triangle][side]];
        considerPush(tag, frame, stretch, outward, scratch, found[index]);
        // beyond a sharp edge lies what no facet faces; of a flat hull, all that is in its plane
        const std::size_t across = hull.neighbours()[triangle][side];
        if (across < triangle) continue;
        const Eigen::Vector3d other = hull.planes().col(static_cast<Eigen::Index>(across)).head<3>();
        if (outward.dot(other) > kSharp) continue;
        const Eigen::Vector3d between = (outward + other).normalized();
        considerPush(tag, frame, stretch, between, scratch, found[index]);
        considerPush(growing.tags()[triangles[triangle][(side + 1) % 3]], frame, stretch, between, scratch,
                     found[index]);
      }
    }
    if (samples_.size() > 1) return;
    for (const Eigen::Vector3d& direction : first) {
      considerPush({0, 0.0F}, frame, stretch, direction, scratch, found[index]);
      considerPush({0, 1.0F}, frame, stretch, direction, scratch, found[index]);
    }
  });
  std::vector<Push> all;
  for (auto& of_set : found) {
    all.insert(all.end(), std::make_move_iterator(of_set.begin()), std::make_move_iterator(of_set.end()));
  }
  return all;
}

std::vector<int> PhaseSearch::key(const Candidate& candidate) const {
  const ToleranceSpace& tolerances = follower_.reader().space().tolerances();
  std::vector<int> key{static_cast<int>(candidate.pose)};
  for (Eigen::Index i = 0; i < candidate.deviations.size(); ++i) {
    const double width = tolerances.upper()[i] - tolerances.lower()[i];
    key.push_back(
        static_cast<int>(std::lround(kSteps * (candidate.deviations[i] - tolerances.lower()[i]) / width)));
  }
  return key;
}

// The candidate of the largest gain first, and after each what it is expected to leave of the others'.
std::vector<PhaseSearch::Candidate> PhaseSearch::choose(const std::vector<Push>& pushes, std::size_t most) {
  const Eigen::Index variables = follower_.reader().space().tolerances().size();
  const auto count = static_cast<Eigen::Index>(pushes.size());
  // side by side: this is gone through for every candidate
  Eigen::MatrixXf gradients(count, variables + poses_.cols());
  Eigen::VectorXf at_sample(count), left(count), gain(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Push& push = pushes[static_cast<std::size_t>(i)];
    gradients.row(i) = push.gradient.transpose().cast<float>();
    at_sample[i] = static_cast<float>(push.gradient.dot(sample_coordinates_[push.sample]));
    gain[i] = left[i] = static_cast<float>(push.gain);
  }
  std::vector<Candidate> chosen;
  Eigen::Index best = 0;
  while (chosen.size() < most && count > 0 && left.maxCoeff(&best) > tolerance_) {
    const Push& push = pushes[static_cast<std::size_t>(best)];
    const Candidate candidate{push.sample, push.target, push.pose};
    left[best] = 0.0F;
    if (!looked_at_.insert(key(candidate)).second) continue;
    chosen.push_back(candidate);
    Eigen::VectorXf coordinates(variables + poses_.cols());
    coordinates << candidate.deviations.cast<float>(),
        poses_.row(static_cast<Eigen::Index>(candidate.pose)).transpose().cast<float>();
    left = left.cwiseMin(gain - (gradients * coordinates - at_sample));
  }
  return chosen;
}

void PhaseSearch::solve(const std::vector<Candidate>& candidates, const std::function<void()>& check) {
  std::vector<FollowedShape> found(candidates.size());
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
    check();
    found[i] = follower_.follow({candidates[i].deviations, times_[candidates[i].pose]}, true);
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    learn(candidates[i], found[i]);
    add(found[i]);
  }
}

// A sample whose derivatives led astray is believed for half the way from then on: beyond a snap lies nothing
// of what they promise.
void PhaseSearch::learn(const Candidate& candidate, const FollowedShape& found) {
  const StretchShape& from = samples_[candidate.sample];
  bool astray = !found.converged || found.jump;
  if (!astray) {
    const Eigen::VectorXd change =
        follower_.coordinates(found.shape.place) - sample_coordinates_[candidate.sample];
    const Eigen::Matrix3Xd expected = from.predicted(change);
    const double error = largestDistance(found.shape.ends[0], expected).distance;
    const double motion = largestDistance(expected, from.ends[0]).distance;
    astray = error > std::hypot(kAstray * motion, tolerance_);
  }
  if (astray) trust_[candidate.sample] *= 0.5;
}

std::size_t PhaseSearch::branchOf(const FollowedShape::Jump& jump) {
  for (std::size_t branch = 1; branch < branches_.size(); ++branch) {
    const double apart = largestDistance(branches_[branch].first_ends, jump.after.ends[0]).distance;
    if (apart < 0.5 * branches_[branch].jump) return branch;
  }
  branches_.emplace_back();
  branches_.back().jump = jump.distance;
  return branches_.size() - 1;
}

void PhaseSearch::add(const FollowedShape& found) {
  ++solves_;
  if (!found.converged) {
    if (failures_++ == 0) failure_ = found.message;
    return;
  }
  std::size_t branch = 0;
  if (found.jump) {
    branch = branchOf(*found.jump);
    const MaterialStretch& stretch = follower_.reader().stretches()[found.jump->stretch];
    insert(found.jump->before, 0);
    insert(found.jump->after, branch);
    snaps_.push_back({found.jump->before.place.deviations, found.jump->after.place.deviations,
                      found.jump->after.place.time, branch, stretch.cable, stretch.start,
                      found.jump->distance});
  }
  insert(found.shape, branch);
}

// Whenever there are half as many shapes more.
void PhaseSearch::fitCurvature() {
  if (samples_.size() < 2 || 2 * samples_.size() < 3 * fitted_) return;
  fitted_ = samples_.size();
  std::vector<bool> believed;
  for (const double trust : trust_) believed.push_back(trust > 0.5);
  curvature_.fit(samples_, sample_coordinates_, believed, widths_);
}

void PhaseSearch::forgetRates() {
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    SamplePlace place = std::move(samples_[i].place);
    samples_[i] = StretchShape();
    samples_[i].place = std::move(place);
    sample_coordinates_[i].resize(0);
    trust_[i] = 0.0;
  }
  curvature_ = CurvatureModel();
  fitted_ = samples_.size();
}

void PhaseSearch::run(std::size_t largest_solves, std::size_t patience, const std::function<void()>& check) {
  rebuild();
  if (patient_until_ == 0) patient_until_ = patience;
  for (;;) {
    check();
    for (; solves_ > patient_until_; patient_until_ += patience) {
      tolerance_ *= 2.0;
      slack_ = std::max(slack_, kSlack * tolerance_);
      updateRadius();
    }
    fitCurvature();
    const std::vector<Candidate> candidates = choose(pushes(), std::min(kShapesPerRound, patience));
    if (candidates.empty()) return;
    if (solves_ + candidates.size() > largest_solves) {
      exhausted_ = true;
      return;
    }
    gained_ = 0.0;
    solve(candidates, check);
    rebuild();
    // what is left was expected to gain less than what has just been tried
    if (gained_ <= tolerance_) return;
  }
}

}  // namespace cable_variation
