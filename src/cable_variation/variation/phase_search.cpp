#include <cable_variation/variation/phase_search.h>

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace cable_variation {
namespace {

constexpr std::size_t kShapesPerRound = 64;
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

}  // namespace

PhaseSearch::PhaseSearch(ShapeFollower follower, std::vector<double> times, double tolerance)
    : follower_(std::move(follower)), times_(std::move(times)), tolerance_(tolerance) {
  const SampleSpace& space = follower_.reader().space();
  const Eigen::Index variables = space.tolerances().size();
  const Eigen::Index others = space.coordinates() - variables;
  poses_.resize(static_cast<Eigen::Index>(times_.size()), others);
  for (std::size_t i = 0; i < times_.size(); ++i) {
    poses_.row(static_cast<Eigen::Index>(i)) =
        follower_.coordinates(space.designAt(times_[i])).tail(others).transpose();
  }
  branches_.emplace_back();
  radius_.assign(follower_.reader().stretches().size(), 0.0);
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
        gained_ = std::max(gained_, of.hulls[frame][i].add(points[k], {sample, share}));
      }
    }
  }
  for (std::size_t i = 0; i < radius_.size(); ++i) {
    radius_[i] = std::max(radius_[i], shape.radius[i] + GrowingHull::kSlack);
  }
  discretisation_error_ = std::max(discretisation_error_, shape.discretisation_error);
  samples_.push_back(shape);
  samples_.back().control.clear();
  sample_coordinates_.push_back(follower_.coordinates(shape.place));
  sample_branch_.push_back(branch);
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
  const double gain =
      scratch.step.dot(scratch.gradient) + 0.5 * scratch.step.dot(scratch.bend.cast<double>() * scratch.step);
  if (gain <= tolerance_) return;
  Push push{tag.sample, scratch.gradient, here.head(variables) + scratch.step.head(variables), pose, gain,
            gain};
  if (looked_at_.count(key({push.target, push.pose})) == 0) pushes.push_back(std::move(push));
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
      for (const std::uint32_t corner : triangles[triangle]) {
        considerPush(growing.tags()[corner], frame, stretch, outward, scratch, found[index]);
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
std::vector<PhaseSearch::Candidate> PhaseSearch::choose(std::vector<Push>& pushes) {
  const Eigen::Index variables = follower_.reader().space().tolerances().size();
  std::vector<Candidate> chosen;
  while (chosen.size() < kShapesPerRound) {
    const auto best = std::max_element(pushes.begin(), pushes.end(),
                                       [](const Push& a, const Push& b) { return a.left < b.left; });
    if (best == pushes.end() || best->left <= tolerance_) break;
    const Candidate candidate{best->target, best->pose};
    best->left = 0.0;
    if (!looked_at_.insert(key(candidate)).second) continue;
    chosen.push_back(candidate);
    Eigen::VectorXd coordinates(variables + poses_.cols());
    coordinates << candidate.deviations, poses_.row(static_cast<Eigen::Index>(candidate.pose)).transpose();
    for (Push& push : pushes) {
      if (push.left <= tolerance_) continue;
      const double gained = push.gradient.dot(coordinates - sample_coordinates_[push.sample]);
      push.left = std::min(push.left, push.gain - gained);
    }
  }
  return chosen;
}

void PhaseSearch::solve(const std::vector<Candidate>& candidates) {
  std::vector<FollowedShape> found(candidates.size());
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
    found[i] = follower_.follow({candidates[i].deviations, times_[candidates[i].pose]}, true);
  });
  for (const FollowedShape& each : found) add(each);
}

std::size_t PhaseSearch::branchOf(const FollowedShape::Jump& jump) {
  for (std::size_t branch = 1; branch < branches_.size(); ++branch) {
    const double apart = (branches_[branch].first_ends - jump.after.ends[0]).colwise().norm().maxCoeff();
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
  const ToleranceSpace& tolerances = follower_.reader().space().tolerances();
  Eigen::VectorXd widths = Eigen::VectorXd::Zero(sample_coordinates_.front().size());
  widths.head(tolerances.size()) = 0.5 * (tolerances.upper() - tolerances.lower());
  for (Eigen::Index i = tolerances.size(); i < widths.size(); ++i) {
    constexpr double kStill = 1e-9;
    widths[i] = std::max(kStill, poses_.col(i - tolerances.size()).cwiseAbs().maxCoeff());
  }
  curvature_.fit(samples_, sample_coordinates_, widths);
}

void PhaseSearch::run(std::size_t largest_solves, const std::function<void()>& check) {
  rebuild();
  for (;;) {
    check();
    fitCurvature();
    std::vector<Push> possible = pushes();
    const std::vector<Candidate> candidates = choose(possible);
    if (candidates.empty()) return;
    if (solves_ + candidates.size() > largest_solves) {
      exhausted_ = true;
      return;
    }
    gained_ = 0.0;
    solve(candidates);
    rebuild();
    // what is left was expected to gain less than what has just been tried
    if (gained_ <= tolerance_) return;
  }
}

}  // namespace cable_variation
