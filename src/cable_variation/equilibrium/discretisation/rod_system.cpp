#include <cable_variation/equilibrium/discretisation/rod_system.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/equilibrium/discretisation/contact_system.h>
#include <cable_variation/equilibrium/discretisation/held_piece.h>
#include <cable_variation/equilibrium/discretisation/rod_system_impl.h>
#include <cable_variation/equilibrium/discretisation/slide_room.h>
#include <cable_variation/math/so3.h>

namespace cable_variation {

using element::kGauss;
using element::kInner;
using element::kLanes;
using element::kNodes;

double NodalField::dot(const NodalField& other) const {
  double sum = unknowns.dot(other.unknowns);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Eigen::Index inner = spans[i].cols() - 2;
    sum += spans[i].middleCols(1, inner).cwiseProduct(other.spans[i].middleCols(1, inner)).sum();
  }
  return sum;
}

void NodalField::addScaled(double factor, const NodalField& other) {
  unknowns += factor * other.unknowns;
  for (std::size_t i = 0; i < spans.size(); ++i) spans[i] += factor * other.spans[i];
}

void NodalField::scale(double factor) {
  unknowns *= factor;
  for (auto& span : spans) span *= factor;
}

RodSystem::RodSystem(const Harness& harness, const Topology& topology, const Grid& grid)
    : harness_(harness),
      topology_(topology),
      grid_(grid),
      unknowns_(harness, topology),
      spans_(topology.spans.size()),
      end_force_(topology.spans.size()),
      stations_(std::make_unique<StationSolver>()) {
  std::size_t elements = 0;
  gradient_.spans.resize(spans_.size());
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanData& data = spans_[i];
    const Span& span = topology.spans[i];
    data.first_element = elements;
    data.elements = grid_[i].size() - 1;
    elements += data.elements;
    const bool left_held = unknowns_.isHeld(span.left);
    const bool right_held = unknowns_.isHeld(span.right);
    data.role.reversed = right_held && !left_held;
    data.role.near_held = left_held || right_held;
    data.role.slides = unknowns_.slide(span.left) >= 0 || unknowns_.slide(span.right) >= 0;
    has_slides_ = has_slides_ || data.role.slides;
    data.nodes.resize(6, static_cast<Eigen::Index>(data.elements) + 1);
    gradient_.spans[i].setZero(6, 3 * static_cast<Eigen::Index>(data.elements) + 1);
  }
  gradient_.unknowns.setZero(unknowns_.count());
  batches_.resize((elements + kLanes - 1) / kLanes);
  for (std::size_t b = 0; b < batches_.size(); ++b) {
    batches_[b].lanes = static_cast<int>(std::min<std::size_t>(kLanes, elements - b * kLanes));
  }
  if (!harness.contacts.empty()) contact_ = std::make_unique<ContactSystem>(harness, topology, grid);
  harnessChanged();
}

void RodSystem::harnessChanged() {
  profiles_.clear();
  for (const Cable& cable : harness_.cables) profiles_.emplace_back(cable);
  reach_ = 0.0;
  for (const Clip& clip : harness_.clips) reach_ = std::max(reach_, clip.pose.position.norm());
  for (SpanData& data : spans_) data.left_arc_length = data.right_arc_length = -1.0;
  if (contact_) contact_->harnessChanged();
}

RodSystem::~RodSystem() = default;

// The weight of everything and all point forces [N].
double RodSystem::loadScale() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Span& span = topology_.spans[i];
    const double left = topology_.stations[span.left].arc_length;
    const double length = topology_.stations[span.right].arc_length - left;
    sum += profiles_[span.cable].at(left + 0.5 * length).mass_per_length * length * harness_.gravity.norm();
  }
  for (const PointLoad& load : harness_.loads) sum += load.force.norm();
  return sum;
}

bool RodSystem::soften(double slenderness, const Configuration& configuration) {
  // The loads stretch no span by more than one in this number.
  constexpr double kStifferThanLoads = 1e3;
  // A span that is stiffer by less is left as it is.
  constexpr double kWorthwhile = 3.0;
  // Of its length: with less slack than this a span's stretch decides whether it bows out.
  constexpr double kTaut = 1e-4;
  std::vector<bool> taut(topology_.stations.size(), false);  // the span to the right of the station
  for (const HeldPiece& piece : heldPieces(harness_, topology_, configuration)) {
    if (piece.distance < (1.0 - kTaut) * piece.length) continue;
    bool inside = false;
    for (const std::size_t station : topology_.cable_stations[piece.cable]) {
      inside = (inside || station == piece.first) && station != piece.last;
      taut[station] = taut[station] || inside;
    }
  }
  const double least = kStifferThanLoads * loadScale();
  bool softer = false;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Span& span = topology_.spans[i];
    const double left = topology_.stations[span.left].arc_length;
    const double length = topology_.stations[span.right].arc_length - left;
    double bending = 0.0, stretching = 0.0;
    for (const double gauss : element::kGaussAt) {
      const RodProperties p = profiles_[span.cable].at(left + gauss * length);
      bending = std::max({bending, p.stiffness[4], p.stiffness[5]});
      stretching = std::max({stretching, p.stiffness[0], p.stiffness[1], p.stiffness[2]});
    }
    const double softened = std::max(slenderness * bending / (length * length), least);
    const bool as_it_is = taut[span.left] || stretching < kWorthwhile * softened;
    const double limit = as_it_is ? INFINITY : softened;
    softer = softer || stretching > limit;
    if (limit == spans_[i].stretch_limit) continue;
    spans_[i].stretch_limit = limit;
    spans_[i].left_arc_length = spans_[i].right_arc_length = -1.0;
  }
  return softer;
}

RodSystem::Element RodSystem::elementOf(std::size_t span, std::size_t element) const {
  const std::size_t global = spans_[span].first_element + element;
  return {global / kLanes, static_cast<int>(global % kLanes)};
}

// Lengths, stiffness, rest curvature and weight of the spans whose stations have moved along their cable.
void RodSystem::refreshProperties(const Configuration& configuration) {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanData& data = spans_[i];
    const Span& span = topology_.spans[i];
    const double left = configuration.stations[span.left].arc_length;
    const double right = configuration.stations[span.right].arc_length;
    if (left == data.left_arc_length && right == data.right_arc_length) continue;
    data.left_arc_length = left;
    data.right_arc_length = right;
    data.bending_stiffness = INFINITY;
    data.stretch_stiffness = data.radius = 0.0;
    for (std::size_t e = 0; e < data.elements; ++e) {
      const Element at = elementOf(i, e);
      Batch& batch = batches_[at.batch];
      const double start = left + grid_[i][e] * (right - left);
      const double length = (grid_[i][e + 1] - grid_[i][e]) * (right - left);
      batch.input.length[at.lane] = length;
      for (int g = 0; g < kGauss; ++g) {
        RodProperties p = profiles_[span.cable].at(start + element::kGaussAt[g] * length);
        for (int k = 0; k < 3; ++k) {
          if (p.stiffness[k] <= data.stretch_limit) continue;
          p.stiffness[k] = data.stretch_limit;
          p.stiffness_slope[k] = 0.0;
        }
        for (int k = 0; k < 6; ++k) {
          batch.input.stiffness[g][k][at.lane] = p.stiffness[k];
          batch.slope.stiffness[g][k][at.lane] = p.stiffness_slope[k];
        }
        for (int k = 0; k < 3; ++k) {
          batch.input.rest_curvature[g][k][at.lane] = p.rest_curvature[k];
          batch.slope.rest_curvature[g][k][at.lane] = p.rest_curvature_slope[k];
          batch.slope.rest_curvature_second[g][k][at.lane] = p.rest_curvature_second[k];
          batch.input.load[g][k][at.lane] = p.mass_per_length * harness_.gravity[k];
          batch.slope.load[g][k][at.lane] = p.mass_slope * harness_.gravity[k];
        }
        data.bending_stiffness = std::min({data.bending_stiffness, p.stiffness[4], p.stiffness[5]});
        data.stretch_stiffness = std::max(data.stretch_stiffness, p.stiffness[0]);
        data.radius = std::max(data.radius, p.radius);
      }
    }
    data.gyration = std::sqrt(data.bending_stiffness / data.stretch_stiffness);
  }
  // unused lanes repeat a used one
  Batch& last = batches_.back();
  const auto repeat = [&](double* lanes) {
    std::fill(lanes + last.lanes, lanes + kLanes, lanes[last.lanes - 1]);
  };
  if (last.lanes < kLanes) {
    repeat(last.input.length);
    for (int g = 0; g < kGauss; ++g) {
      for (int k = 0; k < 6; ++k) repeat(last.input.stiffness[g][k]);
      for (int k = 0; k < 3; ++k) {
        repeat(last.input.rest_curvature[g][k]);
        repeat(last.input.load[g][k]);
      }
    }
  }
}

void RodSystem::gather(const Configuration& configuration) {
  const auto put = [](element::Input& input, int lane, int node, const Eigen::Vector3d& p,
                      const Eigen::Vector4d& q) {
    for (int k = 0; k < 3; ++k) input.position[node][k][lane] = p[k];
    input.quaternion[node][0][lane] = q[3];
    for (int k = 0; k < 3; ++k) input.quaternion[node][k + 1][lane] = q[k];
  };
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const SpanConfiguration& span = configuration.spans[i];
    for (std::size_t e = 0; e < spans_[i].elements; ++e) {
      const Element at = elementOf(i, e);
      Batch& batch = batches_[at.batch];
      Eigen::Vector4d previous = span.orientations[3 * e].coeffs();
      for (int a = 0; a < kNodes; ++a) {
        const std::size_t node = 3 * e + static_cast<std::size_t>(a);
        Eigen::Vector4d q = span.orientations[node].coeffs();
        if (q.dot(previous) < 0.0) q = -q;
        previous = q;
        put(batch.input, at.lane, a, span.positions[node], q);
        if (&batch == &batches_.back() && at.lane == batch.lanes - 1) {
          for (int lane = batch.lanes; lane < kLanes; ++lane)
            put(batch.input, lane, a, span.positions[node], q);
        }
      }
    }
  }
}

void RodSystem::evaluate(const Configuration& configuration, Hessian hessian) {
  const element::Kernel& kernel = element::kernel();
  refreshProperties(configuration);
  gather(configuration);
  for (Batch& batch : batches_) {
    if (hessian == Hessian::none) {
      kernel.energy(batch.input, batch.energy);
    } else {
      kernel.hessian(batch.input, batch.energy, batch.factor, hessian == Hessian::predicted);
    }
    if (has_slides_)
      kernel.arcLength(batch.input, batch.slope, batch.arc_length, hessian == Hessian::predicted);
  }
  energy_ = {};
  for (const Batch& batch : batches_) {
    for (int lane = 0; lane < batch.lanes; ++lane) {
      energy_.elastic += batch.energy.elastic[lane];
      energy_.gravity += batch.energy.load[lane];
    }
  }
  if (contact_) addContact(configuration, hessian != Hessian::none);
  assembleGradient(configuration);
}

std::vector<RodSystem::Metric> RodSystem::bendingMetric() const {
  std::vector<Metric> metric;
  for (const SpanData& data : spans_) {
    const double wave = M_PI / data.length();
    const double rotation = data.bending_stiffness * wave * wave;
    const double position = rotation * wave * wave;
    metric.push_back({position, rotation, rotation, position * data.length()});
  }
  return metric;
}

std::vector<RodSystem::Metric> RodSystem::surfaceMetric() const {
  double total = 0.0;
  for (const SpanData& data : spans_) total += data.length();
  std::vector<Metric> metric;
  for (const SpanData& data : spans_) {
    const double radius2 =
        data.radius > 0.0 ? data.radius * data.radius : 4.0 * data.gyration * data.gyration;
    metric.push_back({1.0 / total, radius2 / total, 0.5 * radius2 / total, 0.0});
  }
  return metric;
}

NodalField RodSystem::zeroField() const {
  NodalField field;
  field.unknowns.setZero(unknowns_.count());
  for (const auto& nodes : gradient_.spans) {
    field.spans.push_back(Eigen::Matrix<double, 6, Eigen::Dynamic>::Zero(6, nodes.cols()));
  }
  return field;
}

bool RodSystem::conservative(const Harness& harness) const {
  for (std::size_t i = 0; i < topology_.stations.size(); ++i) {
    const bool loaded =
        std::any_of(topology_.stations[i].loads.begin(), topology_.stations[i].loads.end(),
                    [&](std::size_t load) { return !harness.loads[load].moment.isZero(0.0); });
    if (loaded && unknowns_.rotations(i) > 1) return false;
  }
  return true;
}

bool RodSystem::arcLengthsInOrder(const Configuration& configuration) const {
  return std::all_of(topology_.spans.begin(), topology_.spans.end(), [&](const Span& span) {
    const double length =
        configuration.stations[span.right].arc_length - configuration.stations[span.left].arc_length;
    const bool fixed = unknowns_.slide(span.left) < 0 && unknowns_.slide(span.right) < 0;
    return fixed || length > leastLength(harness_, topology_, span);
  });
}

double RodSystem::move(const NodalField& motion, Configuration& configuration) const {
  double work = 0.0;
  for (std::size_t i = 0; i < topology_.stations.size(); ++i) {
    for (const UnknownEffect& effect : effects_[i]) {
      work += dead_moment_[i].dot(effect.rotation) * motion.unknowns[effect.unknown];
    }
  }
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanConfiguration& span = configuration.spans[i];
    for (std::size_t node = 1; node + 1 < span.positions.size(); ++node) {
      const auto column = static_cast<Eigen::Index>(node);
      span.positions[node] += motion.spans[i].col(column).head<3>();
      const Eigen::Vector3d turn = motion.spans[i].col(column).tail<3>();
      span.orientations[node] = (span.orientations[node] * so3::exp(turn)).normalized();
    }
  }
  unknowns_.move(motion.unknowns, configuration);
  return work;
}

double RodSystem::elementEnergy(std::size_t span, std::size_t element) const {
  const Element at = elementOf(span, element);
  const element::Energy& energy = batches_[at.batch].energy;
  return energy.elastic[at.lane] + energy.load[at.lane];
}

Vector6d RodSystem::sectionForce(std::size_t span, std::size_t boundary) const {
  const bool first = boundary == 0;
  const Element at = elementOf(span, first ? 0 : boundary - 1);
  const auto& g = batches_[at.batch].energy.gradient;
  Vector6d force;
  for (int k = 0; k < 6; ++k) force[k] = first ? -g[kInner + k][at.lane] : g[kInner + 6 + k][at.lane];
  return force;
}

}  // namespace cable_variation
