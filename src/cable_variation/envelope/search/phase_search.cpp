#include <cable_variation/envelope/search/phase_search.h>

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include <cable_variation/scene/moving_components.h>

namespace cable_variation {
namespace {

// Derivatives that reach so many times as far as those of the reference belong to a shape about to snap,
// where they grow without bound: those of the harness case with ten variables at full tolerance promise
// metres.
constexpr double kAboutToSnap = 4.0;
// Derivatives that miss by this share of the motion lead astray: what they promise elsewhere is not found
// either.
constexpr double kAstray = 0.3;
// A snap whose jump is larger by this is a better one to slice its way by; slicing anew takes all shapes, so
// jumps that are about as large are none.
constexpr double kLarger = 1.3;
// Shapes solved side by side before hulls are looked at anew: enough for all threads of a machine, few beside
// the hundreds that a phase takes.
constexpr std::size_t kMostPerRound = 128;
// Points that stick out of a hull by less than this share of the tolerance, or this length [m], are not taken
// in: pieces are rounded by as much more. The length is what single precision leaves of coordinates in
// metres, some times over.
constexpr double kSlack = 0.2, kLeastSlack = 2e-6;

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
  for (std::size_t i = 0; i < radius_.size(); ++i) {
    own_radius_[i] = std::max(own_radius_[i], shape.radius[i]);
  }
  updateRadius();
  discretisation_error_ = std::max(discretisation_error_, shape.discretisation_error);
  const bool only_held = shape.rates.empty() || samples_.size() >= most_shapes_;
  samples_.push_back(shape);
  to_frame_.push_back(posesOf(shape.place));
  sample_coordinates_.push_back(follower_.coordinates(shape.place));
  sample_branch_.push_back(branch);
  progress_.push_back(way_.of(shape, sample_coordinates_.back().size()));
  const bool believed = !only_held && largestReach(shape) <= kAboutToSnap * reach_;
  trust_.push_back(believed ? 1.0 : 0.0);
  hold(samples_.size() - 1);
  StretchShape& kept = samples_.back();
  kept.control.resize(only_held ? 0 : 1);  // others are seen from it, see pointsOf()
  kept.control.shrink_to_fit();
  if (only_held) {
    kept.rates = {};
    slices_kept_ = true;
  }
}

// What takes each frame's place in the world back, at the time.
std::vector<Pose> PhaseSearch::posesOf(const SamplePlace& place) const {
  const std::vector<std::string>& frames = follower_.reader().frames();
  std::vector<Pose> poses;
  if (frames.size() == 1) return poses;
  const ComponentPoses components = follower_.reader().space().components(place);
  for (const std::string& frame : frames) poses.push_back(poseIn(components, frame).inverse());
  return poses;
}

// A stretch's points as seen from a frame, all that are kept being those in the world.
std::vector<Eigen::Vector3d> PhaseSearch::pointsOf(std::size_t sample, std::size_t frame,
                                                   std::size_t stretch) const {
  const StretchShape& shape = samples_[sample];
  if (frame < shape.control.size()) return shape.control[frame][stretch];
  std::vector<Eigen::Vector3d> points = shape.control.front()[stretch];
  for (Eigen::Vector3d& point : points) point = to_frame_[sample][frame] * point;
  return points;
}

// Adds a sample's points to the hulls of its clusters.
void PhaseSearch::hold(std::size_t sample) {
  const std::size_t frames = follower_.reader().frames().size();
  const SnapWay::Slices slices = way_.slices(progress_[sample].at);
  for (int slice = slices.first; slice <= slices.last; ++slice) {
    Cluster& of = clusterOf(sample_branch_[sample], slice);
    for (std::size_t frame = 0; frame < frames; ++frame) {
      for (std::size_t i = 0; i < radius_.size(); ++i) {
        const std::vector<Eigen::Vector3d> points = pointsOf(sample, frame, i);
        for (std::size_t k = 0; k < points.size(); ++k) {
          const float share = static_cast<float>(k) / static_cast<float>(points.size() - 1);
          const GrowingHull::Tag tag{static_cast<std::uint32_t>(sample), share};
          gained_ = std::max(gained_, of.hulls[frame][i].add(points[k], tag, slack_));
        }
      }
    }
  }
}

PhaseSearch::Cluster& PhaseSearch::clusterOf(std::size_t branch, int slice) {
  for (Cluster& cluster : clusters_) {
    if (cluster.branch == branch && cluster.slice == slice) return cluster;
  }
  clusters_.push_back({branch, slice, {}});
  clusters_.back().hulls.assign(follower_.reader().frames().size(), std::vector<GrowingHull>(radius_.size()));
  return clusters_.back();
}

// Holds all samples in slices of that jump's way.
void PhaseSearch::sliceAlong(const Eigen::Matrix3Xd& motion) {
  if (slices_kept_) return;
  way_ = SnapWay(follower_.reference().ends[0], motion);
  clusters_.clear();
  for (std::size_t sample = 0; sample < samples_.size(); ++sample) {
    progress_[sample] = way_.of(samples_[sample], sample_coordinates_[sample].size());
    hold(sample);
  }
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
  tbb::parallel_for(std::size_t{0}, clusters_.size() * frames * stretches, [&](std::size_t index) {
    clusters_[index / (frames * stretches)].hulls[index / stretches % frames][index % stretches].rebuild();
  });
}

void PhaseSearch::solve(const std::vector<Candidate>& candidates, const std::function<void()>& check) {
  std::vector<FollowedShape> found(candidates.size());
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
    check();
    found[i] = follower_.follow({candidates[i].deviations, times_[candidates[i].pose]}, true);
    tellOf(found[i], follower_.reader().space().tolerances(), witness_);
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

std::size_t PhaseSearch::branchAfter(const Eigen::Matrix3Xd& motion) const {
  for (std::size_t branch = 1; branch < branches_.size(); ++branch) {
    const Eigen::Matrix3Xd& known = branches_[branch].motion;
    const double cosine = known.cwiseProduct(motion).sum() / (known.norm() * motion.norm());
    if (cosine > kAlike) return branch;
    if (cosine < -kAlike) return 0;
  }
  return branches_.size();
}

std::size_t PhaseSearch::takeJump(const FollowedShape::Jump& jump) {
  const Eigen::Matrix3Xd motion = jump.motion();
  const std::size_t branch = branchAfter(motion);
  if (branch == 0) return 0;
  const StretchReader& reader = follower_.reader();
  const MaterialStretch& stretch = reader.stretches()[jump.stretch];
  const Snap snap{jump.before.place.deviations,
                  jump.after.place.deviations,
                  reader.space().tolerances().share(jump.after.place.deviations),
                  jump.after.place.time,
                  branch,
                  stretch.cable,
                  stretch.start,
                  jump.distance};
  if (branch == branches_.size()) {
    branches_.push_back({motion, snap});
  } else if (snap.begins < branches_[branch].nearest.begins) {
    branches_[branch].nearest = snap;
  }
  if (way_.empty() || motion.norm() > kLarger * way_.length()) sliceAlong(motion);
  return branch;
}

bool PhaseSearch::isRare(const StretchShape& shape, bool snapped) const {
  return snapped || way_.slices(way_.of(shape, 0).at).last > 0;
}

std::vector<SamplePlace> PhaseSearch::rarePlaces() const {
  std::vector<SamplePlace> places;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (sample_branch_[i] > 0 || way_.slices(progress_[i].at).last > 0) places.push_back(samples_[i].place);
  }
  return places;
}

void PhaseSearch::add(const FollowedShape& found) {
  ++solves_;
  if (!found.converged) {
    if (failures_++ == 0) failure_ = found.message;
    return;
  }
  std::size_t branch = 0;
  if (found.jump) {
    branch = takeJump(*found.jump);
    insert(found.jump->before, 0);
    insert(found.jump->after, branch);
  }
  const ToleranceSpace& tolerances = follower_.reader().space().tolerances();
  for (const FollowedShape::OnTheWay& kept : found.on_the_way) {
    if (!tolerances.contains(kept.shape.place.deviations)) continue;
    insert(kept.shape, kept.beyond ? branch : 0);
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
  slices_kept_ = true;
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
    const std::vector<Candidate> candidates = choose(pushes(), std::min(kMostPerRound, patience));
    end_ = SearchEnd::no_push;
    if (candidates.empty()) return;
    end_ = SearchEnd::most_shapes;
    if (samples_.size() >= most_shapes_) return;
    end_ = SearchEnd::most_solves;
    if (solves_ + candidates.size() > largest_solves) return;
    gained_ = 0.0;
    solve(candidates, check);
    rebuild();
    // what is left was expected to gain less than what has just been tried
    end_ = SearchEnd::no_gain;
    if (gained_ <= tolerance_) return;
  }
}

}  // namespace cable_variation
