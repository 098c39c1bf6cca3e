#pragma once  // internal to envelope/

#include <functional>
#include <limits>
#include <set>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/envelope/search/curvature_model.h>
#include <cable_variation/envelope/search/growing_hull.h>
#include <cable_variation/tracking/shape_follower.h>
#include <cable_variation/tracking/snap_way.h>

namespace cable_variation {

/// Why a search ended.
enum class SearchEnd {
  not_run,
  no_push,      ///< no facet of a hull is expected to move out by more than the tolerance
  no_gain,      ///< none did, although expected
  most_solves,  ///< the most that were asked for came first
  most_shapes,  ///< the most that may be kept came first
};

/// Looks for the shapes that span the envelope of one phase: the hulls grow where the derivatives of the
/// shapes found so far say that other deviations, or another pose of the motion, lead further out.
class PhaseSearch {
 public:
  /// @param times of the phase's poses; the follower's reference time among them
  /// @param tolerance gain that is not worth a shape [m]
  PhaseSearch(ShapeFollower follower, std::vector<double> times, double tolerance);

  /// Once it keeps so many shapes with what they tell of others, others are only held, and run() ends.
  void setMostShapes(std::size_t most) { most_shapes_ = most; }
  /// From then on shapes are added to the clusters as they are: a larger snap does not slice them anew.
  void keepSlices() { slices_kept_ = true; }
  /// Told of every shape that run() solves.
  void setWitness(const SolvedWitness& witness) { witness_ = witness; }
  /// Takes in a shape found elsewhere, to start from it. Without rates it is only held.
  void add(const FollowedShape& found);
  /// Brings the hulls up to date with what was added; run() does it too.
  void rebuild();
  /// Until no facet of a hull is expected to move out by more than the tolerance, or none did although
  /// expected, or `largest_solves` shapes are solved. `check` is called before each shape, by any thread, and
  /// may throw.
  /// @param patience so many solves later, and again each time, the tolerance doubles
  void run(std::size_t largest_solves, std::size_t patience, const std::function<void()>& check);

  /// Lets go of what the shapes but the first tell of others, which takes most of the memory. A search that
  /// goes on later starts from the first and from those added since.
  void forgetRates();

  const ShapeFollower& follower() const { return follower_; }
  const std::vector<double>& times() const { return times_; }
  std::size_t solves() const { return solves_; }
  std::size_t failures() const { return failures_; }
  double tolerance() const { return tolerance_; }  ///< in the end [m]
  SearchEnd end() const { return end_; }           ///< of run(), the last time
  double discretisationError() const { return discretisation_error_; }
  const std::vector<StretchShape>& samples() const { return samples_; }
  const std::vector<std::size_t>& sampleBranches() const { return sample_branch_; }
  /// Per stretch, the largest with what hulls leave out [m]: twice what the tolerance has grown by, too.
  const std::vector<double>& radius() const { return radius_; }

  /// Shapes that are held together: those of a branch, in one slice of the way that the largest snap takes.
  struct Cluster {
    std::size_t branch = 0;
    int slice = 0;
    std::vector<std::vector<GrowingHull>> hulls;  ///< per frame and stretch
  };
  const std::vector<Cluster>& clusters() const { return clusters_; }
  /// Whether the cluster's shapes snapped, or are on the way of a snap.
  static bool isRare(const Cluster& cluster) { return cluster.branch > 0 || cluster.slice > 0; }
  bool isRare(const StretchShape& shape, bool snapped) const;
  /// Rounds the pieces of rare clusters by so much more [m].
  void roundRare(double beyond) { beyond_ = beyond; }
  /// That a piece of the cluster is rounded by before inflation [m].
  double pieceRadius(const Cluster& cluster, std::size_t stretch) const {
    return radius_[stretch] + (isRare(cluster) ? beyond_ : 0.0);
  }

  /// Jumps are of one kind if their motions have this cosine at least: those of a cable that flips over to
  /// one side or to the other have -1, those of different cables 0.
  static constexpr double kAlike = 0.5;
  /// Equilibria that jumps of one kind lead to. The first is the design's own, followed.
  struct Branch {
    Eigen::Matrix3Xd motion;  ///< of the first jump to it, FollowedShape::Jump::motion(); the first: empty
    Snap nearest;             ///< of those found
  };
  const std::vector<Branch>& branches() const { return branches_; }
  /// Branch that a jump leads to: one whose jumps move the cables alike, the design's own if it goes back,
  /// or, not known yet, as many as there are.
  std::size_t branchAfter(const Eigen::Matrix3Xd& motion) const;
  /// Places of shapes that snapped, or that are on the way of a snap: there are few of them, and more to
  /// find.
  std::vector<SamplePlace> rarePlaces() const;
  const std::string& failure() const { return failure_; }  ///< message of the first

 private:
  // Where a hull could be pushed out.
  struct Push {
    std::size_t sample;        // whose derivatives tell
    Eigen::VectorXd gradient;  // of the height, per coordinate
    Eigen::VectorXd target;    // deviations
    std::size_t pose;          // index into times_
    double gain;               // expected [m]
  };
  struct Candidate {
    std::size_t sample;  // that leads to it
    Eigen::VectorXd deviations;
    std::size_t pose;
  };

  std::vector<Push> pushes() const;
  struct Scratch {
    Eigen::VectorXd gradient, step, heights;
    Eigen::MatrixXf bend;
  };
  void considerPush(const GrowingHull::Tag& tag, int slice, std::size_t frame, std::size_t stretch,
                    const Eigen::Vector3d& outward, Scratch& scratch, std::vector<Push>& pushes) const;
  void climb(const Eigen::VectorXd& here, Scratch& scratch) const;
  void fitCurvature();
  double largestReach(const StretchShape& shape) const;
  std::vector<Candidate> choose(const std::vector<Push>& pushes, std::size_t most);
  void solve(const std::vector<Candidate>& candidates, const std::function<void()>& check);
  void learn(const Candidate& candidate, const FollowedShape& found);
  void insert(const StretchShape& shape, std::size_t branch);
  void updateRadius();
  void hold(std::size_t sample);
  std::vector<Pose> posesOf(const SamplePlace& place) const;
  std::vector<Eigen::Vector3d> pointsOf(std::size_t sample, std::size_t frame, std::size_t stretch) const;
  Cluster& clusterOf(std::size_t branch, int slice);
  std::size_t takeJump(const FollowedShape::Jump& jump);
  void sliceAlong(const Eigen::Matrix3Xd& motion);
  std::vector<int> key(const Candidate& candidate) const;

  ShapeFollower follower_;
  std::vector<double> times_;
  double first_tolerance_, tolerance_;
  double slack_;                   // see kSlack [m]
  std::size_t patient_until_ = 0;  // so many solves
  Eigen::MatrixXd poses_;          // per time, coordinates of the motions relative to the reference
  Eigen::VectorXd widths_;         // per coordinate, half its range
  std::vector<StretchShape> samples_;
  std::vector<Eigen::VectorXd> sample_coordinates_;
  std::vector<std::size_t> sample_branch_;
  std::vector<double> trust_;  // per sample: the share of a way that its derivatives are believed for
  std::vector<double> own_radius_, radius_;  // of the shapes alone, and see radius()
  double beyond_ = 0.0;                      // see roundRare() [m]
  std::vector<SnapWay::Progress> progress_;  // per sample
  std::vector<std::vector<Pose>> to_frame_;  // per sample, by frame; none if only seen from the world
  SnapWay way_;
  SolvedWitness witness_;
  bool slices_kept_ = false;  // or shapes cannot be held anew
  std::size_t most_shapes_ = std::numeric_limits<std::size_t>::max();
  std::vector<Branch> branches_;
  std::vector<Cluster> clusters_;
  CurvatureModel curvature_;
  std::size_t fitted_ = 0;  // shapes that it knows
  std::set<std::vector<int>> looked_at_;
  std::size_t solves_ = 0, failures_ = 0;
  std::string failure_;
  SearchEnd end_ = SearchEnd::not_run;
  double reach_ = 0.0;   // of the reference's derivatives, see largestReach() [m]
  double gained_ = 0.0;  // by the last round: how far its shapes stick out of the hulls before [m]
  double discretisation_error_ = 0.0;
};

}  // namespace cable_variation
