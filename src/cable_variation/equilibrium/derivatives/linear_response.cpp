#include <cable_variation/equilibrium/derivatives/linear_response_impl.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/equilibrium/discretisation/shape_point.h>

namespace cable_variation {

using element::kDofs;
using element::kGauss;
using element::kInner;
using element::kLanes;

LinearResponse::~LinearResponse() = default;

LinearResponse::LinearResponse(RodSystem& system, const Configuration& configuration)
    : system_(system), configuration_(configuration), explicit_(system.batches_.size()), contacts_(system) {
  const element::Kernel& kernel = element::kernel();
  for (std::size_t b = 0; b < explicit_.size(); ++b) {
    const RodSystem::Batch& batch = system.batches_[b];
    kernel.arcLength(batch.input, batch.slope, explicit_[b].by_arc_length, false);
    element::Input input = batch.input;
    element::InputSlope slope = batch.slope;
    std::fill(&input.load[0][0][0], &input.load[0][0][0] + kGauss * 3 * kLanes, 0.0);
    std::fill(&slope.load[0][0][0], &slope.load[0][0][0] + kGauss * 3 * kLanes, 0.0);
    kernel.energy(input, explicit_[b].elastic);
    kernel.arcLength(input, slope, explicit_[b].elastic_by_arc_length, false);
  }
  response_.motion = system.zeroField();
  for (std::size_t i = 0; i < system.spans_.size(); ++i) {
    response_.section_forces.emplace_back(6, static_cast<Eigen::Index>(system.spans_[i].elements) + 1);
    end_stiffness_.emplace_back(system.spans_[i].elements);
    for (std::size_t e = 0; e < end_stiffness_[i].size(); ++e) {
      for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 2; ++column) {
          end_stiffness_[i][e].block<6, 6>(6 * row, 6 * column) =
              system.endStiffness(system.elementOf(i, e), row, column);
        }
      }
    }
  }
}

// Central difference in the properties of one cable, into explicit_.
void LinearResponse::differentiateProperties(const CableRate& cable) {
  const double size =
      std::max({cable.stiffness.cwiseAbs().maxCoeff(), std::abs(cable.mass), std::abs(cable.rest_curvature),
                std::abs(cable.knots) * system_.harness_.cables[cable.cable].length});
  if (size == 0.0) return;
  // The product of stiffness and rest curvature is of higher degree when knots move: then the error is the
  // square of the relative step.
  const double step = 1e-5 / size;
  const element::Kernel& kernel = element::kernel();
  std::vector<std::size_t> batches;
  std::vector<element::Input> inputs[2];
  std::vector<element::InputSlope> slopes[2];
  for (std::size_t i : system_.topology_.cable_spans[cable.cable]) {
    const RodSystem::SpanData& data = system_.spans_[i];
    for (std::size_t e = 0; e < data.elements; ++e) {
      const RodSystem::Element at = system_.elementOf(i, e);
      const RodSystem::Batch& batch = system_.batches_[at.batch];
      if (batches.empty() || batches.back() != at.batch) {
        batches.push_back(at.batch);
        for (auto& side : inputs) side.push_back(batch.input);
        for (auto& side : slopes) side.push_back(batch.slope);
      }
      const double start = data.left_arc_length + system_.grid_[i][e] * data.length();
      for (int g = 0; g < kGauss; ++g) {
        const double s = start + element::kGaussAt[g] * batch.input.length[at.lane];
        const RodProperties rate = propertyRate(system_.profiles_[cable.cable].at(s), s, cable, 0.0);
        for (int side = 0; side < 2; ++side) {
          const double by = side == 0 ? step : -step;
          element::Input& input = inputs[side].back();
          element::InputSlope& slope = slopes[side].back();
          for (int k = 0; k < 6; ++k) {
            input.stiffness[g][k][at.lane] += by * rate.stiffness[k];
            slope.stiffness[g][k][at.lane] += by * rate.stiffness_slope[k];
          }
          for (int k = 0; k < 3; ++k) {
            input.rest_curvature[g][k][at.lane] += by * rate.rest_curvature[k];
            slope.rest_curvature[g][k][at.lane] += by * rate.rest_curvature_slope[k];
            input.load[g][k][at.lane] += by * rate.mass_per_length * system_.harness_.gravity[k];
            slope.load[g][k][at.lane] += by * rate.mass_slope * system_.harness_.gravity[k];
          }
        }
      }
    }
  }
  for (std::size_t j = 0; j < batches.size(); ++j) {
    ExplicitChange& change = explicit_[batches[j]];
    for (int side = 0; side < 2; ++side) {
      const double factor = (side == 0 ? 0.5 : -0.5) / step;
      element::Energy energy;
      kernel.energy(inputs[side][j], energy);
      for (int k = 0; k < kDofs; ++k) {
        for (int lane = 0; lane < kLanes; ++lane)
          change.gradient[k][lane] += factor * energy.gradient[k][lane];
      }
      for (int lane = 0; lane < kLanes; ++lane) change.elastic_energy[lane] += factor * energy.elastic[lane];
      if (!system_.has_slides_) continue;
      element::ArcLength arc_length;
      kernel.arcLength(inputs[side][j], slopes[side][j], arc_length, false);
      for (int end = 0; end < 2; ++end) {
        for (int lane = 0; lane < kLanes; ++lane) {
          change.arc_length_gradient[end][lane] += factor * arc_length.gradient[end][lane];
        }
      }
    }
  }
}

// Adds what moved stations do to the elements' gradient.
void LinearResponse::addArcLengths(const Eigen::VectorXd& arc_lengths) {
  for (std::size_t i = 0; i < system_.spans_.size(); ++i) {
    const Span& span = system_.topology_.spans[i];
    const double left = arc_lengths[static_cast<Eigen::Index>(span.left)];
    const double right = arc_lengths[static_cast<Eigen::Index>(span.right)];
    if (left == 0.0 && right == 0.0) continue;
    for (std::size_t e = 0; e < system_.spans_[i].elements; ++e) {
      const RodSystem::Element at = system_.elementOf(i, e);
      ExplicitChange& change = explicit_[at.batch];
      for (std::size_t end = 0; end < 2; ++end) {
        const double by = left + system_.grid_[i][e + end] * (right - left);
        for (int k = 0; k < kDofs; ++k) {
          change.gradient[k][at.lane] += by * change.by_arc_length.mixed[end][k][at.lane];
        }
      }
    }
  }
}

void LinearResponse::clearExplicit() {
  if (explicit_is_clear_) return;
  for (ExplicitChange& batch : explicit_) {
    std::fill(&batch.gradient[0][0], &batch.gradient[0][0] + kDofs * kLanes, 0.0);
    std::fill(&batch.arc_length_gradient[0][0], &batch.arc_length_gradient[0][0] + 2 * kLanes, 0.0);
    std::fill(batch.elastic_energy, batch.elastic_energy + kLanes, 0.0);
  }
  explicit_is_clear_ = true;
}

// Fills explicit_; whether there is anything but moved clips.
bool LinearResponse::differentiateExplicitly(const HarnessChange& change) {
  clearExplicit();
  if (change.cables.empty() && change.arc_lengths.isZero(0.0)) return false;
  explicit_is_clear_ = false;
  for (const CableRate& cable : change.cables) differentiateProperties(cable);
  addArcLengths(change.arc_lengths);
  return true;
}

// Subtracts the gradient's explicit change.
void LinearResponse::addForce(const HarnessChange& change, NodalField& field) const {
  for (std::size_t i = 0; i < system_.spans_.size(); ++i) {
    const RodSystem::SpanData& data = system_.spans_[i];
    const Span& span = system_.topology_.spans[i];
    auto& nodes = field.spans[i];
    const Eigen::Vector2d moved(change.arc_lengths[static_cast<Eigen::Index>(span.left)],
                                change.arc_lengths[static_cast<Eigen::Index>(span.right)]);
    Eigen::Vector2d slide =
        data.role.slides ? Eigen::Vector2d(data.slide_second * moved) : Eigen::Vector2d::Zero();
    for (std::size_t e = 0; e < data.elements; ++e) {
      const RodSystem::Element at = system_.elementOf(i, e);
      const ExplicitChange& batch = explicit_[at.batch];
      const auto first = static_cast<Eigen::Index>(3 * e);
      for (int k = 0; k < 6; ++k) {
        nodes(k, first) -= batch.gradient[kInner + k][at.lane];
        nodes(k, first + 1) -= batch.gradient[k][at.lane];
        nodes(k, first + 2) -= batch.gradient[6 + k][at.lane];
        nodes(k, first + 3) -= batch.gradient[kInner + 6 + k][at.lane];
      }
      for (std::size_t end = 0; end < 2; ++end) {
        const double share = system_.grid_[i][e + end];
        slide += batch.arc_length_gradient[end][at.lane] * Eigen::Vector2d(1.0 - share, share);
      }
    }
    Vector14d ends;
    ends << nodes.col(0), nodes.col(nodes.cols() - 1), -slide;
    system_.addToUnknowns(i, ends, field.unknowns);
    nodes.col(0).setZero();
    nodes.col(nodes.cols() - 1).setZero();
  }
}

// The balance of a station's unknowns is that of its force and moment along their axes: subtracts what the
// axes' turning does to it. For a rotation, the slope of the gradient along η and then along E is H(η, E) + ½
// m·(η × E), with the moment m in the section frame.
void LinearResponse::turnAxes(const HarnessChange& change, Eigen::VectorXd& force) const {
  const auto& stations = system_.topology_.stations;
  std::vector<Vector6d> gradient(stations.size(), Vector6d::Zero());
  for (std::size_t i = 0; i < system_.spans_.size(); ++i) {
    gradient[system_.topology_.spans[i].left] += system_.end_force_[i][0];
    gradient[system_.topology_.spans[i].right] += system_.end_force_[i][1];
  }
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const Eigen::Vector3d turn = change.frame_turn.col(column);
    const Eigen::Vector3d carried = change.carried.col(column).tail<3>();
    Eigen::Vector3d pull = gradient[i].head<3>();
    for (std::size_t load : stations[i].loads) pull -= system_.harness_.loads[load].force;
    const Eigen::Vector3d moment = 0.5 * gradient[i].tail<3>() - system_.dead_moment_[i];
    for (const UnknownEffect& effect : system_.effects_[i]) {
      force[effect.unknown] -=
          pull.dot(turn.cross(effect.displacement)) + effect.rotation.dot(moment.cross(carried));
    }
  }
}

const HarnessResponse& LinearResponse::to(const HarnessChange& change) {
  bool is_explicit = differentiateExplicitly(change);
  Eigen::VectorXd opened;
  if (!contacts_.none()) {
    opened = moveParts(change);
    is_explicit = true;
    explicit_is_clear_ = false;
  }
  NodalField& motion = response_.motion;
  motion.scale(0.0);
  if (is_explicit) addForce(change, motion);
  turnAxes(change, motion.unknowns);
  system_.solveCarried(change.carried, motion, !is_explicit);
  if (!contacts_.none()) {
    response_.contact_forces = contacts_.hold(opened, motion);
    addContactForces(response_.contact_forces);
  }

  Eigen::VectorXd slides = Eigen::VectorXd::Zero(change.arc_lengths.size());
  for (std::size_t i = 0; i < system_.topology_.stations.size(); ++i) {
    const int slide = system_.unknowns_.slide(i);
    if (slide >= 0) slides[static_cast<Eigen::Index>(i)] = motion.unknowns[slide];
  }
  const bool slid = !slides.isZero(0.0);
  if (slid) {
    explicit_is_clear_ = false;
    addArcLengths(slides);
  }
  response_.arc_lengths = change.arc_lengths + slides;
  findSectionForces(is_explicit || slid);
  response_.elastic_energy = elasticEnergy();
  return response_;
}

// Forces at the elements' ends: their stiffness, inner nodes eliminated, times the ends' motion, and what
// changes explicitly.
void LinearResponse::findSectionForces(bool is_explicit) {
  const element::Kernel& kernel = element::kernel();
  if (is_explicit) {
    for (std::size_t b = 0; b < explicit_.size(); ++b) {
      kernel.condense(system_.batches_[b].factor, explicit_[b].gradient);
    }
  }
  for (std::size_t i = 0; i < system_.spans_.size(); ++i) {
    const std::size_t elements = system_.spans_[i].elements;
    auto& forces = response_.section_forces[i];
    for (std::size_t boundary = 0; boundary <= elements; ++boundary) {
      const std::size_t e = boundary == 0 ? 0 : boundary - 1;
      const double sign = boundary == 0 ? -1.0 : 1.0;
      const RodSystem::Element at = system_.elementOf(i, e);
      const RodSystem::Batch& batch = system_.batches_[at.batch];
      const auto first = static_cast<Eigen::Index>(3 * e);
      const int side = boundary == 0 ? 0 : 1;
      const int row = kInner + 6 * side;
      const auto& motion = response_.motion.spans[i];
      const auto& stiffness = end_stiffness_[i][e];
      Vector6d rate = stiffness.block<6, 6>(6 * side, 0) * motion.col(first) +
                      stiffness.block<6, 6>(6 * side, 6) * motion.col(first + 3);
      for (int r = 0; is_explicit && r < 6; ++r) rate[r] += explicit_[at.batch].gradient[row + r][at.lane];
      Eigen::Vector3d moment;
      for (int k = 0; k < 3; ++k) moment[k] = batch.energy.gradient[row + 3 + k][at.lane];
      const auto node = static_cast<Eigen::Index>(3 * boundary);
      const Eigen::Vector3d turn = motion.col(node).tail<3>();
      const Eigen::Quaterniond& orientation = configuration_.spans[i].orientations[3 * boundary];
      // H θ is short of the slope of the moment in the section frame by ½ m × θ; seen from the world the
      // frame turns by θ × m
      const Eigen::Vector3d in_section = rate.tail<3>() + 0.5 * turn.cross(moment);
      forces.col(static_cast<Eigen::Index>(boundary)) << sign * rate.head<3>(),
          sign * (orientation * in_section);
    }
  }
}

double LinearResponse::elasticEnergy() const {
  double sum = 0.0;
  for (std::size_t b = 0; b < explicit_.size(); ++b) {
    for (int lane = 0; lane < system_.batches_[b].lanes; ++lane) sum += explicit_[b].elastic_energy[lane];
  }
  for (std::size_t i = 0; i < system_.spans_.size(); ++i) {
    const Span& span = system_.topology_.spans[i];
    const double left = response_.arc_lengths[static_cast<Eigen::Index>(span.left)];
    const double right = response_.arc_lengths[static_cast<Eigen::Index>(span.right)];
    const auto& nodes = response_.motion.spans[i];
    for (std::size_t e = 0; e < system_.spans_[i].elements; ++e) {
      const RodSystem::Element at = system_.elementOf(i, e);
      const ExplicitChange& batch = explicit_[at.batch];
      const auto first = static_cast<Eigen::Index>(3 * e);
      for (int k = 0; k < 6; ++k) {
        sum += batch.elastic.gradient[kInner + k][at.lane] * nodes(k, first) +
               batch.elastic.gradient[k][at.lane] * nodes(k, first + 1) +
               batch.elastic.gradient[6 + k][at.lane] * nodes(k, first + 2) +
               batch.elastic.gradient[kInner + 6 + k][at.lane] * nodes(k, first + 3);
      }
      for (std::size_t end = 0; end < 2; ++end) {
        sum += (left + system_.grid_[i][e + end] * (right - left)) *
               batch.elastic_by_arc_length.gradient[end][at.lane];
      }
    }
  }
  return sum;
}

}  // namespace cable_variation
