#pragma once  // internal to equilibrium/

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/discretisation/problem.h>
#include <cable_variation/rod/kernel/chain_kernel.h>

namespace cable_variation {

/// What RodSystem is for one harness, for several side by side: harnesses that differ from a solved one in
/// numbers only, on its grid, each in a lane of the vector registers. The elements are RodSystem's own
/// (element::Kernel); where its lanes are elements of one harness, here they are the same element of several.
///
/// What a lane holds depends on its own harness alone, bit for bit, not on what is in the other lanes.
class LaneSystem {
 public:
  static constexpr int kLanes = element::kLanes;
  using Lanes = std::array<double, kLanes>;
  using Flags = std::array<bool, kLanes>;

  /// All lanes at the problem's shape, with its Hessian factorised: what others start from. Keeps a
  /// reference. Throws std::invalid_argument: a clip that slides, or a dead moment without potential.
  explicit LaneSystem(const Problem& nominal);
  ~LaneSystem();
  LaneSystem(const LaneSystem&) = delete;
  LaneSystem& operator=(const LaneSystem&) = delete;

  /// All lanes to the nominal shape; `nominal` is of the same problem.
  void restart(const LaneSystem& nominal);
  /// A harness into a lane that has the nominal shape: its numbers, and its clips' poses for predict().
  /// False, and the lane is as it was: the harness is of another structure.
  bool load(int lane, const Harness& harness);

  /// Instead of load(): the harnesses and shapes in the `lanes` of `fine`, whose grid has two elements for
  /// each here; read off its polynomials.
  void merge(const LaneSystem& fine, const Flags& lanes);

  /// The stresses there are as those predicted, in all lanes.
  void takeStress();

  /// Energy, gradient, and with `hessian` the elements' Hessian with the geometric part of the predicted
  /// stresses, factorised together with chains and stations.
  void evaluate(bool hessian);
  /// Largest out-of-balance force as RodSystem::residual() [N], per lane. Not a number: there is one among
  /// the forces.
  const Lanes& residual() const { return residual_; }
  /// Pivots of the last factorisation that are not positive, per lane.
  const std::array<int, kLanes>& negativePivots() const { return negative_; }

  /// The first-order motion to the harnesses loaded, from the nominal shape and with its factors.
  void predict(const LaneSystem& nominal);
  /// Newton's step with the factors at hand, which may be those of an earlier shape.
  void step();
  /// Largest displacement [m] and rotation [rad] of the motion last solved for, per lane.
  const Lanes& displacement() const { return displacement_; }
  const Lanes& rotation() const { return rotation_; }
  /// After step(), per lane: DiscretisationError::force, the worst of all cables. `fine` is what was merged.
  Lanes forceErrors(const LaneSystem& fine) const;
  /// Moves the active lanes by the motion; before an evaluation with the Hessian, with the section forces
  /// predicted along the way.
  void move(const Flags& active, bool predict_stress);

  /// Of the shape that was evaluated last: a solved cable's points, reactions and energy as describe() and
  /// describeShapes() give them.
  void describe(int lane, Equilibrium& result) const;
  /// The largest stretch or compression at an element's end.
  double largestStretch(int lane) const;
  const Harness& harness(int lane) const;
  /// Its nodes and stations, as a RodSystem on the same grid takes them.
  void read(int lane, Configuration& configuration) const;

 private:
  struct Element;
  struct SpanLanes;
  struct Lane;
  struct ForceChange;

  void loadRod(int lane, std::size_t span);
  void putEnds(int lane);
  void factorise(const SpanLanes& span, Element& element);
  void factoriseChain(SpanLanes& span);
  void evaluateStations(int lane, bool hessian);
  void factoriseStations(int lane);
  void condenseElements(const LaneSystem& by);
  void condenseChains(const LaneSystem& by);
  void pushByHeldEnds(const LaneSystem& by);
  void solveStations(const LaneSystem& by, bool carried);
  void expand(const LaneSystem& by);
  Eigen::Matrix<double, 12, 12> reduced(std::size_t span, int lane) const;
  Vector6d endForce(std::size_t span, int end, int lane) const;
  Vector6d sectionForce(std::size_t span, std::size_t boundary, int lane) const;
  Pose pose(std::size_t span, std::size_t boundary, int lane) const;
  ForceChange forceChange(const LaneSystem& fine, const std::vector<std::size_t>& spans) const;
  static void forceAfter(const Element& at, int end, double (*after)[kLanes]);
  static double forceError(const ForceChange& change, double length, std::size_t lane);

  const Problem& problem_;
  std::vector<Element> elements_;
  std::vector<SpanLanes> spans_;
  std::vector<std::unique_ptr<Lane>> lanes_;
  Lanes residual_{}, displacement_{}, rotation_{};
  std::array<int, kLanes> negative_{};
};

}  // namespace cable_variation
