#include <hunt/discrete_rod.h>

#include <algorithm>
#include <cmath>

#include <hunt/discrete_element.h>
#include <hunt/rotation.h>

namespace cable_variation::hunt {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Kind = ClipFreedom::Kind;

namespace {

bool allFree(const std::array<ClipFreedom, 3>& freedoms) {
  return std::all_of(freedoms.begin(), freedoms.end(),
                     [](const ClipFreedom& f) { return f.kind == Kind::free; });
}

}  // namespace

DiscreteRod::DiscreteRod(const Harness& harness, DiscreteLayout layout)
    : harness_(harness), layout_(std::move(layout)) {
  for (const Cable& cable : harness_.cables) profiles_.emplace_back(cable);
  number();
  measure();
}

void DiscreteRod::number() {
  unknown_.resize(layout_.stations.size());
  const auto three = [this](std::array<int, 3>& unknowns) {
    for (int& unknown : unknowns) unknown = count_++;
  };
  for (std::size_t i = 0; i < layout_.stations.size(); ++i) {
    const DiscreteStation& station = layout_.stations[i];
    StationUnknowns& own = unknown_[i];
    if (station.clip) {
      const ClipConstraint& holds = harness_.clips[*station.clip].constraint;
      own.chart = !allFree(holds.rotation);
      for (std::size_t k = 0; k < 3; ++k) {
        if (holds.translation[k].kind != Kind::locked) own.translation[k] = count_++;
        if (holds.rotation[k].kind != Kind::locked) own.rotation[k] = count_++;
      }
      if (holds.slides) own.slide = count_++;
    } else if (station.joint) {
      const Joint::Type type = harness_.joints[*station.joint].type;
      if (type == Joint::Type::pivot) three(own.rotation);
      if (type == Joint::Type::hinge) own.hinge = count_++;
    } else {
      three(own.translation);
      three(own.rotation);
    }
  }
  raw_count_ = static_cast<int>(7 * layout_.stations.size());
  for (const DiscretePiece& piece : layout_.pieces) {
    first_raw_.push_back(raw_count_);
    first_unknown_.push_back(count_);
    const int more = 3 * static_cast<int>(2 * piece.segments() - 1);
    raw_count_ += more;
    count_ += more;
  }
}

void DiscreteRod::measure() {
  double total = 0.0;
  for (const Cable& cable : harness_.cables) {
    total += cable.length;
    const Section& section = cable.sections.front().section;
    load_scale_ += section.mass_per_length * cable.length * harness_.gravity.norm();
  }
  for (const PointLoad& load : harness_.loads) load_scale_ += load.force.norm();
  surface_metric_ = VectorXd::Zero(count_);
  bending_metric_ = VectorXd::Zero(count_);
  extent_ = VectorXd::Ones(count_);
  struct Share {
    double surface, bending, extent;
  };
  const auto put = [this](int unknown, const Share& share) {
    if (unknown < 0) return;
    surface_metric_[unknown] += share.surface;
    bending_metric_[unknown] += share.bending;
    extent_[unknown] = share.extent;
  };
  for (std::size_t i = 0; i < layout_.pieces.size(); ++i) {
    const DiscretePiece& piece = layout_.pieces[i];
    const Cable& cable = harness_.cables[piece.cable];
    const Section& section = cable.sections.front().section;
    const double softest = std::min({section.EI_y, section.EI_z, section.GJ});
    const double length = layout_.stations[piece.right].arc_length - layout_.stations[piece.left].arc_length;
    // the surface turns by its radius about x, half of it about y and z; a rigid place has no length to turn
    const double radius2 = std::pow(std::max(section.radius, 1e-6 * cable.length), 2);
    const auto shift = [&](double h) -> Share {
      return {h / total, softest / std::pow(cable.length, 3), cable.length};
    };
    const auto turn = [&](double h, int axis) -> Share {
      return {(axis == 0 ? 1.0 : 0.5) * radius2 * h / total, softest / cable.length, 1.0};
    };
    const double none = 1e-9 * cable.length;
    for (std::size_t k = 0; k < piece.segments(); ++k) {
      const double h = length * (piece.at[k + 1] - piece.at[k]);
      const double before = k == 0 ? 0.0 : length * (piece.at[k] - piece.at[k - 1]);
      for (int c = 0; c < 3; ++c) {
        put(first_unknown_[i] + 3 * static_cast<int>(piece.segments() - 1 + k) + c, turn(h, c));
        if (k > 0) put(first_unknown_[i] + 3 * static_cast<int>(k - 1) + c, shift(0.5 * (h + before)));
      }
    }
    for (const bool left : {true, false}) {
      const std::size_t at = left ? 1 : piece.segments();
      const double h = 0.5 * length * (piece.at[at] - piece.at[at - 1]);
      const StationUnknowns& own = unknown_[left ? piece.left : piece.right];
      for (int unknown : own.translation) put(unknown, shift(h));
      for (int c = 0; c < 3; ++c) put(own.rotation[static_cast<std::size_t>(c)], turn(none, c));
      put(own.hinge, turn(none, 0));
      put(own.slide, shift(none));
    }
  }
}

int DiscreteRod::rawVertex(std::size_t piece, std::size_t k) const {
  if (k == 0) return rawStation(layout_.pieces[piece].left);
  if (k == layout_.pieces[piece].segments()) return rawStation(layout_.pieces[piece].right);
  return first_raw_[piece] + 3 * static_cast<int>(k - 1);
}

bool DiscreteRod::positionKnown(std::size_t station) const {
  const auto& clip = layout_.stations[station].clip;
  return clip && !allFree(harness_.clips[*clip].constraint.translation);
}

bool DiscreteRod::orientationKnown(std::size_t station) const {
  const auto& clip = layout_.stations[station].clip;
  return clip && !allFree(harness_.clips[*clip].constraint.rotation);
}

void DiscreteRod::place(DiscreteShape& shape) const {
  for (std::size_t i : layout_.parents_first) {
    const DiscreteStation& station = layout_.stations[i];
    DiscreteShape::Station& at = shape.stations[i];
    if (station.clip) {
      const Clip& clip = harness_.clips[*station.clip];
      at.position = clip.pose.position + clip.pose.orientation * at.offset;
      if (unknown_[i].chart) at.orientation = clip.pose.orientation * rotationBy(at.theta);
    } else if (station.joint) {
      const Joint& joint = harness_.joints[*station.joint];
      const DiscreteShape::Station& parent = shape.stations[station.parent];
      at.position = parent.position;
      if (joint.type != Joint::Type::pivot) {
        at.orientation = parent.orientation * joint.rotation * rotationBy(at.hinge * joint.axis);
      }
    }
    at.orientation.normalize();
  }
}

double DiscreteRod::softened(const RodProperties& rod, std::size_t piece, double share,
                             const RodModel& model) const {
  if (!std::isfinite(model.cap)) return 1.0;
  // the length before any sliding: else sliding would change the stiffness
  const DiscretePiece& of = layout_.pieces[piece];
  const double h = share * (layout_.stations[of.right].arc_length - layout_.stations[of.left].arc_length);
  const double bending = std::min(rod.stiffness[4], rod.stiffness[5]) / (h * h);
  const double least = std::max(model.cap * bending, 30.0 * load_scale_);
  return std::min(1.0, least / rod.stiffness[0]);
}

double DiscreteRod::size(const VectorXd& step) const {
  return step.cwiseQuotient(extent_).cwiseAbs().maxCoeff();
}

double DiscreteRod::largestShare(const VectorXd& step, const DiscreteShape& shape, double turn,
                                 double shift) const {
  double share = 1.0;
  const auto bound = [&share](double value, double most) {
    if (std::abs(value) > most) share = std::min(share, most / std::abs(value));
  };
  for (Eigen::Index i = 0; i < step.size(); ++i) {
    // of a rotation the extent is 1; cables of a metre's length are bounded alike
    bound(step[i] / extent_[i], extent_[i] == 1.0 ? std::max(turn, shift) : shift);
  }
  for (const DiscretePiece& piece : layout_.pieces) {
    const auto slid = [&](std::size_t station) {
      const int slide = unknown_[station].slide;
      return slide < 0 ? 0.0 : step[slide];
    };
    const double room = shape.stations[piece.right].arc_length - shape.stations[piece.left].arc_length;
    const double used = slid(piece.left) - slid(piece.right);
    if (used > 0.0) bound(used, 0.5 * room);
  }
  return share;
}

double DiscreteRod::largestStretch(const DiscreteShape& shape, double* sign_of) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < layout_.pieces.size(); ++i) {
    const DiscretePiece& piece = layout_.pieces[i];
    const double length = shape.stations[piece.right].arc_length - shape.stations[piece.left].arc_length;
    for (std::size_t k = 0; k < piece.segments(); ++k) {
      const double h = length * (piece.at[k + 1] - piece.at[k]);
      const double strain = (shape.vertex(piece, i, k + 1) - shape.vertex(piece, i, k)).norm() / h - 1.0;
      if (std::abs(strain) <= largest) continue;
      largest = std::abs(strain);
      if (sign_of != nullptr) *sign_of = strain < 0.0 ? -1.0 : 1.0;
    }
  }
  return largest;
}

double DiscreteRod::smallestRoom(const DiscreteShape& shape) const {
  double smallest = 1.0;
  for (const DiscretePiece& piece : layout_.pieces) {
    if (!slides(piece.left) && !slides(piece.right)) continue;
    const double room = shape.stations[piece.right].arc_length - shape.stations[piece.left].arc_length;
    smallest = std::min(smallest, room / harness_.cables[piece.cable].length);
  }
  return smallest;
}

}  // namespace cable_variation::hunt
