// A random harness through solve(), update() and a batch: one that is sound is solved or said to have no
// shape, in numbers; one that is not is refused, by all three.
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <cable_variation/equilibrium/batch_solver.h>
#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/harness/clip_preset.h>

#include "fuzz_bytes.h"
#include "fuzz_input.h"

namespace cable_variation {
namespace {

Pose randomPose(FuzzBytes& bytes) {
  Pose pose;
  pose.position = bytes.vector(0.5);
  pose.orientation = so3::exp(bytes.vector(2.0));
  return pose;
}

Cable randomCable(FuzzBytes& bytes, std::size_t index) {
  constexpr Material kBundle{1e8, 0.25, 2000.0};
  Cable cable;
  cable.name = "cable " + std::to_string(index);
  cable.length = bytes.number(0.05, 1.0);
  cable.sections = {{0.0, solidSection(bytes.number(0.001, 0.01), kBundle)}};
  if (bytes.chance(4))
    cable.sections.push_back({bytes.number(0.0, cable.length), hoseSection(0.01, 0.008, kBundle)});
  if (bytes.chance(4)) cable.rest_curvature = {{0.0, bytes.vector(10.0)}, {cable.length, bytes.vector(10.0)}};
  if (bytes.chance(6)) cable.via = {bytes.vector(0.5)};
  if (bytes.chance(6)) cable.twist = bytes.number(-10.0, 10.0);
  return cable;
}

double randomPlace(FuzzBytes& bytes, const Harness& harness, std::size_t cable) {
  const double length = cable < harness.cables.size() ? harness.cables[cable].length : 1.0;
  switch (bytes.below(3)) {
    case 0:
      return 0.0;
    case 1:
      return length;
    default:
      return bytes.number(0.0, 1.02 * length);
  }
}

Clip randomClip(FuzzBytes& bytes, const Harness& harness, std::size_t index) {
  ClipParameters parameters;
  parameters.axis = static_cast<Axis>(bytes.below(3));
  parameters.normal = static_cast<Axis>(bytes.below(3));
  parameters.rolls = bytes.chance(2);
  parameters.slides = bytes.chance(8);
  parameters.stiffness = {bytes.number(1.0, 1e4), bytes.number(1.0, 1e4), bytes.number(0.01, 10.0),
                          bytes.number(0.01, 10.0)};
  for (ClipFreedom& freedom : parameters.translation)
    freedom.kind = static_cast<ClipFreedom::Kind>(bytes.below(3));
  for (ClipFreedom& freedom : parameters.translation) freedom.stiffness = bytes.number(1.0, 1e4);
  const ClipPresetTable& presets = clipPresets();
  const ClipPresetTraits& preset = bytes.chance(2) ? presets[bytes.below(presets.size())] : presets[0];
  Clip clip;
  clip.name = "clip " + std::to_string(index);
  clip.type = preset.name;
  clip.cable = bytes.below(static_cast<unsigned>(harness.cables.size()) + (bytes.chance(32) ? 1U : 0U));
  clip.arc_length = randomPlace(bytes, harness, clip.cable);
  clip.constraint = preset.constraint(parameters);
  clip.pose = randomPose(bytes);
  clip.attached = !bytes.chance(8);
  return clip;
}

Joint randomJoint(FuzzBytes& bytes, const Harness& harness) {
  Joint joint;
  joint.name = "joint";
  joint.type = static_cast<Joint::Type>(bytes.below(3));
  joint.parent = bytes.below(static_cast<unsigned>(harness.cables.size()));
  joint.child = bytes.below(static_cast<unsigned>(harness.cables.size()));
  joint.parent_arc_length = randomPlace(bytes, harness, joint.parent);
  joint.child_arc_length = randomPlace(bytes, harness, joint.child);
  joint.rotation = so3::exp(bytes.vector(2.0));
  return joint;
}

Harness randomHarness(FuzzBytes& bytes) {
  Harness harness;
  const unsigned cables = 1 + bytes.below(3), clips = 1 + bytes.below(6);
  for (unsigned c = 0; c < cables; ++c) harness.cables.push_back(randomCable(bytes, c));
  for (unsigned c = 0; c < clips; ++c) harness.clips.push_back(randomClip(bytes, harness, c));
  for (unsigned j = 1; j < cables; ++j) harness.joints.push_back(randomJoint(bytes, harness));
  if (bytes.chance(3)) {
    const unsigned cable = bytes.below(cables);
    harness.loads.push_back({"load", cable, randomPlace(bytes, harness, cable), bytes.vector(20.0),
                             bytes.chance(2) ? bytes.vector(0.1) : Eigen::Vector3d::Zero()});
  }
  if (bytes.chance(4)) harness.gravity = bytes.vector(20.0);
  return harness;
}

/// In numbers only, little.
Harness changed(FuzzBytes& bytes, Harness harness) {
  for (Clip& clip : harness.clips) clip.pose.position += bytes.vector(0.01);
  for (PointLoad& load : harness.loads) load.force += bytes.vector(1.0);
  return harness;
}

void requireSense(const Equilibrium& equilibrium, const Harness& harness) {
  if (!equilibrium.converged()) {
    if (equilibrium.message.empty()) throw std::logic_error("no shape, and no word why");
    return;
  }
  if (equilibrium.shapes.size() != harness.cables.size()) throw std::logic_error("a cable has no shape");
  if (equilibrium.clip_reactions.size() != harness.clips.size())
    throw std::logic_error("a clip has no reaction");
  for (const CableShape& shape : equilibrium.shapes) {
    for (const ShapePoint& point : shape.points) {
      if (!point.pose.position.allFinite() || !point.force.allFinite() || !point.moment.allFinite()) {
        throw std::logic_error("a shape has what is no number");
      }
    }
  }
}

std::optional<Equilibrium> answered(const Harness& harness,
                                    const std::function<Equilibrium(const Harness&)>& solve) {
  const bool sound = faultsOf(harness).empty();
  try {
    const Equilibrium equilibrium = solve(harness);
    if (!sound) throw std::logic_error("solved what is not sound");
    requireSense(equilibrium, harness);
    return equilibrium;
  } catch (const std::invalid_argument& error) {
    if (sound) throw std::logic_error(std::string("refused what is sound: ") + error.what());
    if (*error.what() == '\0') throw std::logic_error("a refusal without a message");
    return std::nullopt;
  }
}

void solveBatch(FuzzBytes& bytes, const EquilibriumSolver& solver, const Harness& nominal) {
  std::vector<Harness> harnesses;
  for (std::size_t i = 0; i < BatchSolver::kBatch; ++i) {
    Harness harness = changed(bytes, nominal);
    if (faultsOf(harness).empty()) harnesses.push_back(std::move(harness));
  }
  if (harnesses.empty()) return;
  BatchSolver batch(solver);
  batch.solve(harnesses.data(), harnesses.size());
  for (std::size_t i = 0; i < harnesses.size(); ++i) {
    if (batch.outcome(i).converged()) requireSense(batch.describe(i), harnesses[i]);
  }
}

}  // namespace
}  // namespace cable_variation

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cable_variation;
  FuzzBytes bytes(data, size);
  return acceptsOrRefuses([&] {
    EquilibriumOptions options;
    options.accuracy = 1e-3;
    options.force_accuracy = 1e-1;
    options.max_iterations = 40;
    options.multi_start = bytes.chance(4);
    EquilibriumSolver solver(options);
    const Harness harness = randomHarness(bytes);
    const auto first = answered(harness, [&](const Harness& asked) { return solver.solve(asked); });
    answered(changed(bytes, harness), [&](const Harness& asked) { return solver.update(asked); });
    if (first && first->converged()) solveBatch(bytes, solver, harness);
  });
}
