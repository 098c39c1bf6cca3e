#include <cable_variation/envelope/search/phase_search.h>

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace cable_variation {
namespace {

constexpr double kSharp = 0.87;  // cosine between the normals of facets that meet at a sharp edge: 30 degrees
// Derivatives believed for less than this share of a way are not believed at all.
constexpr double kLeastTrust = 0.1;
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

// From a shape on the facet on: its own derivatives, with the curvature that all shapes together tell.
void PhaseSearch::considerPush(const GrowingHull::Tag& tag, int slice, std::size_t frame, std::size_t stretch,
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
  if (!way_.empty()) {  // what is in another slice there does not push this one's hull
    const SnapWay::Progress& from = progress_[tag.sample];
    if (!way_.slices(from.at + from.rates.dot(scratch.step)).contain(slice)) return;
  }
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
  const std::size_t sets = clusters_.size() * frames * stretches;
  std::vector<std::vector<Push>> found(sets);
  const std::vector<Eigen::Vector3d> first = firstDirections();
  tbb::parallel_for(std::size_t{0}, sets, [&](std::size_t index) {
    const std::size_t frame = index / stretches % frames, stretch = index % stretches;
    const Cluster& cluster = clusters_[index / (frames * stretches)];
    const GrowingHull& growing = cluster.hulls[frame][stretch];
    if (growing.empty()) return;
    Scratch scratch;
    const ConvexHull& hull = growing.hull();
    const auto& triangles = hull.surface().triangles;
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
      const Eigen::Vector3d outward = hull.planes().col(static_cast<Eigen::Index>(triangle)).head<3>();
      for (std::size_t side = 0; side < 3; ++side) {
        const GrowingHull::Tag& tag = growing.tags()[triangles[triangle][side]];
        considerPush(tag, cluster.slice, frame, stretch, outward, scratch, found[index]);
        // beyond a sharp edge lies what no facet faces; of a flat hull, all that is in its plane
        const std::size_t across = hull.neighbours()[triangle][side];
        if (across < triangle) continue;
        const Eigen::Vector3d other = hull.planes().col(static_cast<Eigen::Index>(across)).head<3>();
        if (outward.dot(other) > kSharp) continue;
        const Eigen::Vector3d between = (outward + other).normalized();
        considerPush(tag, cluster.slice, frame, stretch, between, scratch, found[index]);
        considerPush(growing.tags()[triangles[triangle][(side + 1) % 3]], cluster.slice, frame, stretch,
                     between, scratch, found[index]);
      }
    }
    if (samples_.size() > 1) return;
    for (const Eigen::Vector3d& direction : first) {
      considerPush({0, 0.0F}, 0, frame, stretch, direction, scratch, found[index]);
      considerPush({0, 1.0F}, 0, frame, stretch, direction, scratch, found[index]);
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

}  // namespace cable_variation
