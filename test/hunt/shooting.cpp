#include <hunt/shooting.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/SparseLU>

#include <hunt/rod_integration.h>
#include <hunt/rotation.h>

namespace cable_variation::hunt {
namespace {

using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector12 = Eigen::Matrix<double, 12, 1>;

constexpr double kRounded = 1e-9;  // arc lengths this near are one [of the cable]

// The pieces between sections, and what is unknown: of each section its motion, force and moment, after it
// the reactions; all over the cable's own scales.
class Shooting {
 public:
  Shooting(const Harness& harness, const Equilibrium& answer);

  bool solve();
  ShotReactions result() const;

 private:
  Eigen::Index reaction(std::size_t clip) const { return 12 * count() + 6 * static_cast<Eigen::Index>(clip); }
  Eigen::Index count() const { return static_cast<Eigen::Index>(states_.size()); }
  bool at(double arc_length, std::size_t section) const {
    return std::abs(arc_length - places_[section]) < kRounded * places_.back();
  }
  RodState moved(const RodState& state, const Vector12& motion) const;
  Vector12 difference(const RodState& a, const RodState& b) const;
  Vector12 shot(std::size_t piece, const RodState& from) const;
  Vector6 jump(std::size_t section) const;
  Vector6 hold(std::size_t clip, const RodState& section, const Vector6& reaction) const;
  void put(Eigen::Index row, Eigen::Index column, const Eigen::MatrixXd& block);
  void putPiece(std::size_t piece);
  void putClips();

  const Harness& harness_;
  RodProfile profile_;
  double length_, force_ = 0.0, moment_ = 0.0;  // scales
  std::vector<double> places_;
  std::vector<RodState> states_;
  std::vector<Vector6> reactions_;  // [N], [N m], world
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd residual_;
};

Shooting::Shooting(const Harness& harness, const Equilibrium& answer)
    : harness_(harness), profile_(harness.cables.at(0)), length_(harness.cables[0].length) {
  constexpr double kLayers = 3.0;  // √(EI/T): in one piece an error grows by e to this power
  if (harness.cables.size() != 1 || !harness.joints.empty())
    throw std::invalid_argument("shooting is for one cable");
  for (const Clip& clip : harness.clips) {
    if (clip.constraint.slides) throw std::invalid_argument("clip '" + clip.name + "' slides; expected none");
  }
  const std::vector<ShapePoint>& points = answer.shapes.at(0).points;
  for (const ShapePoint& point : points) {
    force_ = std::max(force_, point.force.norm());
    moment_ = std::max(moment_, point.moment.norm());
  }
  const auto add = [this](double place, const Pose& pose, const Vector3d& force, const Vector3d& moment) {
    places_.push_back(place);
    states_.push_back({pose.position, pose.orientation, force, moment});
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ShapePoint& point = points[i];
    if (i > 0 && point.arc_length - points[i - 1].arc_length > kRounded * length_) {
      const ShapePoint& before = points[i - 1];
      const double h = point.arc_length - before.arc_length;
      const double softest = profile_.at(point.arc_length).stiffness.tail<2>().minCoeff();
      const double force = std::max(point.force.norm(), before.force.norm());
      const int pieces = static_cast<int>(std::ceil(h / kLayers * std::sqrt(force / softest)));
      for (int k = 1; k < pieces; ++k) {
        const double t = static_cast<double>(k) / pieces;
        add(before.arc_length + t * h, answer.shapes[0].pose(before.arc_length + t * h),
            (1.0 - t) * before.force + t * point.force, (1.0 - t) * before.moment + t * point.moment);
      }
    }
    if (i > 0 && at(point.arc_length, places_.size() - 1)) {  // the side s+ counts
      states_.back() = {point.pose.position, point.pose.orientation, point.force, point.moment};
    } else {
      add(point.arc_length, point.pose, point.force, point.moment);
    }
  }
  states_.back().force.setZero();  // beyond the end
  states_.back().moment.setZero();
  for (const Reaction& of : answer.clip_reactions) {
    reactions_.emplace_back();
    reactions_.back() << of.force, of.moment;
  }
}

RodState Shooting::moved(const RodState& state, const Vector12& motion) const {
  RodState result = state;
  result.position += length_ * motion.head<3>();
  result.orientation = (state.orientation * rotationBy(motion.segment<3>(3))).normalized();
  result.force += force_ * motion.segment<3>(6);
  result.moment += moment_ * motion.tail<3>();
  return result;
}

Vector12 Shooting::difference(const RodState& a, const RodState& b) const {
  Vector12 result;
  result << (a.position - b.position) / length_, rotationVector(b.orientation.conjugate() * a.orientation),
      (a.force - b.force) / force_, (a.moment - b.moment) / moment_;
  return result;
}

// What is pulled at a section from outside, by loads and clips [N], [N m].
Vector6 Shooting::jump(std::size_t section) const {
  Vector6 sum = Vector6::Zero();
  for (const PointLoad& load : harness_.loads) {
    if (at(load.arc_length, section)) sum += (Vector6() << load.force, load.moment).finished();
  }
  for (std::size_t c = 0; c < harness_.clips.size(); ++c) {
    if (at(harness_.clips[c].arc_length, section)) sum += reactions_[c];
  }
  return sum;
}

// By how much the piece misses the next section.
Vector12 Shooting::shot(std::size_t piece, const RodState& from) const {
  RodState end = integrateRod(profile_, harness_.gravity, from, places_[piece], places_[piece + 1], 1e-10);
  const Vector6 outside = jump(piece + 1);
  end.force -= outside.head<3>();
  end.moment -= outside.tail<3>();
  return difference(end, states_[piece + 1]);
}

// What a clip holds is where it holds it, and pulls nowhere else but by its springs.
Vector6 Shooting::hold(std::size_t clip, const RodState& section, const Vector6& reaction) const {
  const Clip& of = harness_.clips[clip];
  const Vector3d shift = of.pose.orientation.conjugate() * (section.position - of.pose.position);
  const Vector3d force = of.pose.orientation.conjugate() * reaction.head<3>();
  const Vector3d turn = rotationVector(of.pose.orientation.conjugate() * section.orientation);
  const Vector3d moment =
      rightJacobian(turn).transpose() * (section.orientation.conjugate() * reaction.tail<3>());
  Vector6 result;
  for (int k = 0; k < 6; ++k) {
    const bool turns = k >= 3;
    const auto axis = static_cast<std::size_t>(k % 3);
    const ClipFreedom& freedom = turns ? of.constraint.rotation[axis] : of.constraint.translation[axis];
    const double by = turns ? turn[k % 3] : shift[k % 3] / length_;
    const double pull = turns ? moment[k % 3] / moment_ : force[k % 3] / force_;
    const double spring = freedom.stiffness * (turns ? 1.0 / moment_ : length_ / force_);
    result[k] = freedom.kind == ClipFreedom::Kind::locked ? by
                : freedom.kind == ClipFreedom::Kind::free ? pull
                                                          : (pull + spring * by) / (1.0 + spring);
  }
  return result;
}

void Shooting::put(Eigen::Index row, Eigen::Index column, const Eigen::MatrixXd& block) {
  for (Eigen::Index r = 0; r < block.rows(); ++r) {
    for (Eigen::Index c = 0; c < block.cols(); ++c) {
      if (block(r, c) != 0.0)
        entries_.emplace_back(static_cast<int>(row + r), static_cast<int>(column + c), block(r, c));
    }
  }
}

void Shooting::putPiece(std::size_t piece) {
  constexpr double kStep = 1e-6;
  const auto row = 12 * static_cast<Eigen::Index>(piece);
  const Vector12 here = shot(piece, states_[piece]);
  residual_.segment<12>(row) = here;
  Eigen::Matrix<double, 12, 12> slope;
  for (int k = 0; k < 12; ++k)
    slope.col(k) = (shot(piece, moved(states_[piece], kStep * Vector12::Unit(k))) - here) / kStep;
  put(row, row, slope);
  put(row, row + 12, -Eigen::Matrix<double, 12, 12>::Identity());
}

void Shooting::putClips() {
  constexpr double kStep = 1e-7;
  const Eigen::Index first_row = 12 * (count() - 1);
  // nothing is beyond the start and the end
  const Vector6 outside = jump(0);
  residual_.segment<3>(first_row) = (states_.front().force + outside.head<3>()) / force_;
  residual_.segment<3>(first_row + 3) = (states_.front().moment + outside.tail<3>()) / moment_;
  residual_.segment<3>(first_row + 6) = states_.back().force / force_;
  residual_.segment<3>(first_row + 9) = states_.back().moment / moment_;
  put(first_row, 6, Eigen::Matrix<double, 6, 6>::Identity());
  put(first_row + 6, 12 * (count() - 1) + 6, Eigen::Matrix<double, 6, 6>::Identity());
  for (std::size_t c = 0; c < harness_.clips.size(); ++c) {
    std::size_t section = 0;
    while (!at(harness_.clips[c].arc_length, section)) ++section;
    if (section == 0) {
      put(first_row, reaction(c), Eigen::Matrix<double, 6, 6>::Identity());
    } else {
      put(12 * static_cast<Eigen::Index>(section - 1) + 6, reaction(c),
          -Eigen::Matrix<double, 6, 6>::Identity());
    }
    const Eigen::Index row = first_row + 12 + 6 * static_cast<Eigen::Index>(c);
    const Vector6 here = hold(c, states_[section], reactions_[c]);
    residual_.segment<6>(row) = here;
    Eigen::Matrix<double, 6, 6> by_motion, by_reaction;
    for (int k = 0; k < 6; ++k) {
      const RodState turned = moved(states_[section], kStep * Vector12::Unit(k));
      by_motion.col(k) = (hold(c, turned, reactions_[c]) - here) / kStep;
      const Vector6 more = reactions_[c] + kStep * (k < 3 ? force_ : moment_) * Vector6::Unit(k);
      by_reaction.col(k) = (hold(c, states_[section], more) - here) / kStep;
    }
    put(row, 12 * static_cast<Eigen::Index>(section), by_motion);
    put(row, reaction(c), by_reaction);
  }
}

bool Shooting::solve() {
  constexpr int kSteps = 12;
  constexpr double kAtRest = 1e-7;  // differences leave no more
  const Eigen::Index size = 12 * count() + 6 * static_cast<Eigen::Index>(harness_.clips.size());
  for (int step = 0; step < kSteps; ++step) {
    entries_.clear();
    residual_.setZero(size);
    for (std::size_t i = 0; i + 1 < states_.size(); ++i) putPiece(i);
    putClips();
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(matrix);
    if (factor.info() != Eigen::Success) return false;
    const Eigen::VectorXd motion = -factor.solve(residual_);
    if (!motion.allFinite()) return false;
    for (std::size_t i = 0; i < states_.size(); ++i)
      states_[i] = moved(states_[i], motion.segment<12>(12 * static_cast<Eigen::Index>(i)));
    for (std::size_t c = 0; c < reactions_.size(); ++c) {
      reactions_[c].head<3>() += force_ * motion.segment<3>(reaction(c));
      reactions_[c].tail<3>() += moment_ * motion.segment<3>(reaction(c) + 3);
    }
    if (motion.cwiseAbs().maxCoeff() < kAtRest) return true;
  }
  return false;
}

ShotReactions Shooting::result() const {
  ShotReactions result;
  constexpr double kNoTurn = 0.01;  // along the cable [rad]
  result.solved = true;
  result.largest_moment = kNoTurn * profile_.at(0.0).stiffness.tail<2>().minCoeff() / length_;
  result.largest_force = result.largest_moment / length_;
  for (const RodState& state : states_) {
    result.largest_force = std::max(result.largest_force, state.force.norm());
    result.largest_moment = std::max(result.largest_moment, state.moment.norm());
  }
  for (std::size_t c = 0; c < reactions_.size(); ++c) {
    Reaction reaction;
    reaction.name = harness_.clips[c].name;
    reaction.force = reactions_[c].head<3>();
    reaction.moment = reactions_[c].tail<3>();
    // those at the end are in no section
    result.largest_force = std::max(result.largest_force, reaction.force.norm());
    result.largest_moment = std::max(result.largest_moment, reaction.moment.norm());
    result.clips.push_back(reaction);
  }
  return result;
}

}  // namespace

double ShotReactions::errorOf(const Equilibrium& answer) const {
  double error = 0.0;
  for (std::size_t c = 0; c < clips.size(); ++c) {
    error = std::max({error, (clips[c].force - answer.clip_reactions[c].force).norm() / largest_force,
                      (clips[c].moment - answer.clip_reactions[c].moment).norm() / largest_moment});
  }
  return error;
}

ShotReactions shoot(const Harness& harness, const Equilibrium& answer) {
  Shooting shooting(harness, answer);
  if (!shooting.solve()) return {};
  return shooting.result();
}

}  // namespace cable_variation::hunt
