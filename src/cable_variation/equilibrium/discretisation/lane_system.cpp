#include <cable_variation/equilibrium/discretisation/lane_system.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <cable_variation/equilibrium/discretisation/lane_system_impl.h>
#include <cable_variation/math/so3.h>

namespace cable_variation {

using element::kDofs;
using element::kFirstDof;
using element::kGauss;
using element::kInner;
using element::kNodes;

namespace {

bool sameSection(const Section& a, const Section& b) {
  return a.EA == b.EA && a.GA_y == b.GA_y && a.GA_z == b.GA_z && a.GJ == b.GJ && a.EI_y == b.EI_y &&
         a.EI_z == b.EI_z && a.mass_per_length == b.mass_per_length;
}

// Whether two cables have the same properties at every arc length.
bool sameRod(const Cable& a, const Cable& b) {
  return std::equal(a.sections.begin(), a.sections.end(), b.sections.begin(), b.sections.end(),
                    [](const SectionAt& x, const SectionAt& y) {
                      return x.arc_length == y.arc_length && sameSection(x.section, y.section);
                    }) &&
         std::equal(a.rest_curvature.begin(), a.rest_curvature.end(), b.rest_curvature.begin(),
                    b.rest_curvature.end(), [](const RestCurvatureAt& x, const RestCurvatureAt& y) {
                      return x.arc_length == y.arc_length && x.curvature == y.curvature;
                    });
}

// Of the element's nodes, in its cubic polynomials at `place`, 0 to 1.
std::array<double, kNodes> weightsAt(double place) {
  std::array<double, kNodes> weights;
  for (std::size_t a = 0; a < kNodes; ++a) {
    weights[a] = 1.0;
    for (std::size_t b = 0; b < kNodes; ++b) {
      if (b != a) weights[a] *= (place - element::kNodeAt[b]) / (element::kNodeAt[a] - element::kNodeAt[b]);
    }
  }
  return weights;
}

void refuse(const Problem& problem) {
  const Harness& harness = problem.harness;
  for (std::size_t i = 0; i < problem.topology.stations.size(); ++i) {
    if (problem.system->unknowns().slide(i) < 0) continue;
    throw std::invalid_argument("clip '" + harness.clips[*problem.topology.stations[i].clip].name +
                                "' slides; many harnesses at once are solved for clips that do not");
  }
  if (!problem.system->conservative()) {
    const auto moment = std::find_if(harness.loads.begin(), harness.loads.end(),
                                     [](const PointLoad& load) { return !load.moment.isZero(0.0); });
    throw std::invalid_argument("load '" + moment->name +
                                "' has a moment on a section that turns freely; many harnesses at once are "
                                "solved for loads with a potential");
  }
}

}  // namespace

LaneSystem::~LaneSystem() = default;

LaneSystem::LaneSystem(const Problem& nominal) : problem_(nominal), spans_(nominal.topology.spans.size()) {
  refuse(nominal);
  const StationUnknowns& unknowns = nominal.system->unknowns();
  const std::vector<RodSystem::Metric> metric = nominal.system->bendingMetric();
  std::size_t elements = 0;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Span& span = nominal.topology.spans[i];
    SpanLanes& lanes = spans_[i];
    const bool left_held = unknowns.isHeld(span.left);
    const bool right_held = unknowns.isHeld(span.right);
    lanes.first_element = elements;
    lanes.count = nominal.system->elementCount(i);
    elements += lanes.count;
    lanes.role.reversed = right_held && !left_held;
    lanes.role.near_held = left_held || right_held;
    lanes.far_held = left_held && right_held;
    lanes.metric = metric[i];
    std::fill(std::begin(lanes.gyration), std::end(lanes.gyration), nominal.system->gyration(i));
    lanes.links.resize(lanes.count - 1);
    lanes.nodes.resize(lanes.count);
  }
  elements_.resize(elements);
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const SpanConfiguration& nodes = nominal.configuration.spans[i];
    Eigen::Vector4d previous = nodes.orientations.front().coeffs();
    for (std::size_t e = 0; e < spans_[i].count; ++e) {
      element::Input& input = elements_[spans_[i].first_element + e].input;
      for (std::size_t a = 0; a < kNodes; ++a) {
        Eigen::Vector4d q = nodes.orientations[3 * e + a].coeffs();
        if (q.dot(previous) < 0.0) q = -q;
        previous = q;
        for (int lane = 0; lane < kLanes; ++lane) {
          for (int k = 0; k < 3; ++k) {
            input.position[a][k][lane] = nodes.positions[3 * e + a][k];
            input.quaternion[a][k + 1][lane] = q[k];
          }
          input.quaternion[a][0][lane] = q[3];
        }
      }
    }
  }
  for (int lane = 0; lane < kLanes; ++lane) {
    lanes_.push_back(std::make_unique<Lane>(nominal));
    for (std::size_t i = 0; i < spans_.size(); ++i) loadRod(lane, i);
  }
  takeStress();
  evaluate(true);
}

// The stresses there are, for the Hessian: those predicted for no motion.
void LaneSystem::takeStress() {
  alignas(64) static constexpr double kNoMotion[kDofs][kLanes] = {};
  for (Element& element : elements_) {
    element::kernel().predict(element.input, kNoMotion, element.input.stress);
  }
}

void LaneSystem::restart(const LaneSystem& nominal) {
  for (std::size_t e = 0; e < elements_.size(); ++e) elements_[e].input = nominal.elements_[e].input;
  for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
    lanes_[lane]->configuration.stations = nominal.lanes_[lane]->configuration.stations;
    lanes_[lane]->carried.setZero();
  }
}

bool LaneSystem::load(int index, const Harness& harness) {
  const auto arc_lengths = stationArcLengths(problem_.harness, problem_.topology, harness);
  if (!arc_lengths) return false;
  Lane& lane = *lanes_[static_cast<std::size_t>(index)];
  lane.harness = harness;
  std::vector<StationConfiguration>& stations = lane.configuration.stations;
  for (std::size_t i = 0; i < stations.size(); ++i) stations[i].arc_length = (*arc_lengths)[i];
  placeStations(lane.harness, problem_.topology, lane.configuration);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Pose& from = problem_.configuration.stations[i].pose;
    const Pose& to = stations[i].pose;
    lane.carried.col(static_cast<Eigen::Index>(i)) << to.position - from.position,
        so3::log(from.orientation.conjugate() * to.orientation);
  }
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Span& span = problem_.topology.spans[i];
    const auto moved = [&](std::size_t station) {
      return stations[station].arc_length != problem_.configuration.stations[station].arc_length;
    };
    if (moved(span.left) || moved(span.right) || harness.gravity != problem_.harness.gravity ||
        !sameRod(harness.cables[span.cable], problem_.harness.cables[span.cable])) {
      loadRod(index, i);
    }
  }
  return true;
}

void LaneSystem::merge(const LaneSystem& fine, const Flags& lanes) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!lanes[lane]) continue;
    load(static_cast<int>(lane), fine.lanes_[lane]->harness);
    lanes_[lane]->configuration.stations = fine.lanes_[lane]->configuration.stations;
  }
  // an element's inner nodes lie within the halves
  static const std::array<std::array<double, kNodes>, 2> kWeights = {
      weightsAt(2.0 * element::kNodeAt[1]), weightsAt(2.0 * element::kNodeAt[2] - 1.0)};
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    element::Input& input = elements_[e].input;
    const element::Input* const halves[2] = {&fine.elements_[2 * e].input, &fine.elements_[2 * e + 1].input};
    for (int half = 0; half < 2; ++half) {
      const int end = half == 0 ? 0 : kNodes - 1, inner = half + 1;
      const element::Input& of = *halves[half];
      for (int lane = 0; lane < kLanes; ++lane) {
        double p[3] = {}, q[4] = {}, norm2 = 0.0;
        for (std::size_t a = 0; a < kNodes; ++a) {
          const double weight = kWeights[static_cast<std::size_t>(half)][a];
          for (int k = 0; k < 3; ++k) p[k] += weight * of.position[a][k][lane];
          for (int k = 0; k < 4; ++k) q[k] += weight * of.quaternion[a][k][lane];
        }
        for (double component : q) norm2 += component * component;
        for (int k = 0; k < 3; ++k) {
          input.position[end][k][lane] = of.position[end][k][lane];
          input.position[inner][k][lane] = p[k];
        }
        for (int k = 0; k < 4; ++k) {
          input.quaternion[end][k][lane] = of.quaternion[end][k][lane];
          input.quaternion[inner][k][lane] = q[k] / std::sqrt(norm2);
        }
      }
    }
  }
  takeStress();
}

// Lengths, stiffness, rest curvature and weight of a span's elements.
void LaneSystem::loadRod(int index, std::size_t span_index) {
  const Lane& lane = *lanes_[static_cast<std::size_t>(index)];
  const SpanLanes& lanes = spans_[span_index];
  const Span& span = problem_.topology.spans[span_index];
  const std::vector<double>& grid = problem_.system->grid()[span_index];
  const RodProfile profile(lane.harness.cables[span.cable]);
  const double left = lane.configuration.stations[span.left].arc_length;
  const double whole = lane.configuration.stations[span.right].arc_length - left;
  for (std::size_t e = 0; e < lanes.count; ++e) {
    element::Input& input = elements_[lanes.first_element + e].input;
    const double start = left + grid[e] * whole;
    const double length = (grid[e + 1] - grid[e]) * whole;
    input.length[index] = length;
    for (int g = 0; g < kGauss; ++g) {
      const RodProperties p = profile.at(start + element::kGaussAt[g] * length);
      for (int k = 0; k < 6; ++k) input.stiffness[g][k][index] = p.stiffness[k];
      for (int k = 0; k < 3; ++k) {
        input.rest_curvature[g][k][index] = p.rest_curvature[k];
        input.load[g][k][index] = p.mass_per_length * lane.harness.gravity[k];
      }
    }
  }
}

void LaneSystem::evaluate(bool hessian) {
  const element::Kernel& kernel = element::kernel();
  const element::ChainKernel& chain = element::chainKernel();
  alignas(64) double largest[kLanes] = {};
  negative_.fill(0);
  for (SpanLanes& span : spans_) {
    for (std::size_t j = 0; j <= span.count; ++j) {
      std::fill(&span.node(j).of[0][0], &span.node(j).of[0][0] + 6 * kLanes, 0.0);
    }
    for (std::size_t j = 0; j < span.count; ++j) {
      Element& at = elements_[span.element(j)];
      if (hessian) {
        kernel.hessian(at.input, at.energy, at.factor, true);
        factorise(span, at);
      } else {
        kernel.energy(at.input, at.energy);
      }
      chain.force(at.energy, at.rows, span.endOf(j, 0).of, span.endOf(j, 1).of);
      chain.largest(at.rows, kInner / 6, span.gyration, largest);
      if (j > 0) chain.largest(span.node(j).of, 1, span.gyration, largest);
    }
    if (hessian) factoriseChain(span);
  }
  std::copy(std::begin(largest), std::end(largest), residual_.begin());
  for (int lane = 0; lane < kLanes; ++lane) evaluateStations(lane, hessian);
}

void LaneSystem::move(const Flags& active, bool predict_stress) {
  const element::Kernel& kernel = element::kernel();
  const element::ChainKernel& chain = element::chainKernel();
  alignas(64) double shares[kLanes], squared_displacement[kLanes] = {}, squared_rotation[kLanes] = {};
  for (std::size_t lane = 0; lane < kLanes; ++lane) shares[lane] = active[lane] ? 1.0 : 0.0;
  for (Element& element : elements_) {
    if (predict_stress) kernel.predict(element.input, element.rows, element.input.stress);
    chain.advance(element.input, element.rows, shares, squared_displacement, squared_rotation);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    displacement_[lane] = std::sqrt(squared_displacement[lane]);
    rotation_[lane] = std::sqrt(squared_rotation[lane]);
    if (!active[lane]) continue;
    Lane& of = *lanes_[lane];
    if (of.unknowns.count() > 0) of.unknowns.move(of.step, of.configuration);
    putEnds(static_cast<int>(lane));
  }
}

// The spans' end nodes to their stations.
void LaneSystem::putEnds(int index) {
  const Lane& lane = *lanes_[static_cast<std::size_t>(index)];
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Span& span = problem_.topology.spans[i];
    for (int end = 0; end < 2; ++end) {
      element::Input& input = elements_[spans_[i].first_element + (end == 0 ? 0 : spans_[i].count - 1)].input;
      const int node = end == 0 ? 0 : kNodes - 1;
      const Pose& pose = lane.configuration.stations[end == 0 ? span.left : span.right].pose;
      const Eigen::Quaterniond& q = pose.orientation;
      const double of[4] = {q.w(), q.x(), q.y(), q.z()};
      double same = 0.0;
      for (int k = 0; k < 4; ++k) same += of[k] * input.quaternion[node][k][index];
      for (int k = 0; k < 4; ++k) input.quaternion[node][k][index] = same < 0.0 ? -of[k] : of[k];
      for (int k = 0; k < 3; ++k) input.position[node][k][index] = pose.position[k];
    }
  }
}

const Harness& LaneSystem::harness(int lane) const { return lanes_[static_cast<std::size_t>(lane)]->harness; }

}  // namespace cable_variation
