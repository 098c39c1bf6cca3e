#include <cable_variation/scene/deviations.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <cable_variation/math/so3.h>
#include <cable_variation/scene/locating_scheme.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

[[noreturn]] void refuseUnknown(const Scene& scene, const DesignValues& values) {
  for (const auto& entry : values) {
    const bool known =
        std::any_of(scene.design_variables.begin(), scene.design_variables.end(),
                    [&](const DesignVariable& variable) { return variable.name == entry.first; });
    if (!known) throw std::invalid_argument("there is no design variable '" + entry.first + "'");
  }
  throw std::invalid_argument("the scene has two design variables of one name");
}

void add(const Scene& scene, std::size_t index, double value, Deviations& all) {
  const DesignTarget& target = scene.design_variables[index].target;
  if (const auto* t = std::get_if<ClipTranslation>(&target)) {
    all.clips[t->clip].translation[static_cast<int>(t->axis)] += value;
  } else if (const auto* r = std::get_if<ClipRotation>(&target)) {
    all.clips[r->clip].rotation[static_cast<int>(r->axis)] += value;
  } else if (const auto* ct = std::get_if<ComponentTranslation>(&target)) {
    all.components[ct->component].translation[static_cast<int>(ct->axis)] += value;
  } else if (const auto* cr = std::get_if<ComponentRotation>(&target)) {
    all.components[cr->component].rotation[static_cast<int>(cr->axis)] += value;
  } else if (const auto* l = std::get_if<LocatorDeviation>(&target)) {
    all.locators[l->component][l->locator] += value;
  } else {
    all.quantities.emplace_back(index, value);
  }
}

// Fills the frames of components after those of what they ride on.
class FrameBuilder {
 public:
  FrameBuilder(const Scene& scene, const Deviations& deviations, const ComponentPoses& moved)
      : scene_(scene), deviations_(deviations), moved_(moved), state_(scene.components.size(), State::open) {
    frames_.resize(scene.components.size());
    for (std::size_t i = 0; i < frames_.size(); ++i) build(i);
  }

  std::vector<ComponentFrame> take() { return std::move(frames_); }

 private:
  enum class State { open, begun, done };

  void build(std::size_t index) {
    if (state_[index] == State::done) return;
    const Component& part = scene_.components[index];
    if (state_[index] == State::begun) {
      throw std::invalid_argument("component '" + part.name + "' rides on itself");
    }
    state_[index] = State::begun;
    ComponentFrame& frame = frames_[index];
    frame.parent = componentIndex(scene_, part.parent);
    Pose carried;  // what the deviations of the parent do to the world
    frame.designed = part.pose;
    if (frame.parent != ComponentFrame::kWorld) {
      build(frame.parent);
      const ComponentFrame& parent = frames_[frame.parent];
      carried = parent.pose * parent.designed.inverse();
      frame.designed = parent.designed * part.pose;
    }
    if (!moved_.empty()) {
      const auto given = moved_.find(part.name);
      if (given != moved_.end()) frame.designed = given->second;
    }
    frame.base = carried * frame.designed;
    frame.located = locatedBy(index);
    frame.pose = frame.base * frame.located * deviations_.components[index].pose();
    state_[index] = State::done;
  }

  Pose locatedBy(std::size_t index) const {
    const std::array<double, 6>& deviations = deviations_.locators[index];
    if (std::all_of(deviations.begin(), deviations.end(), [](double d) { return d == 0.0; })) return {};
    const Component& part = scene_.components[index];
    try {
      return locatedPose(part.locators, deviations);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("component '" + part.name + "': " + error.what());
    }
  }

  const Scene& scene_;
  const Deviations& deviations_;
  const ComponentPoses& moved_;
  std::vector<State> state_;
  std::vector<ComponentFrame> frames_;
};

}  // namespace

Pose Deviation::pose() const { return {translation, so3::exp(rotation)}; }

Deviations deviationsOf(const Scene& scene, const DesignValues& values) {
  Deviations all;
  all.clips.resize(scene.harness.clips.size());
  all.components.resize(scene.components.size());
  all.locators.resize(scene.components.size());
  if (values.empty()) return all;
  std::size_t found = 0;
  for (std::size_t i = 0; i < scene.design_variables.size(); ++i) {
    const DesignVariable& variable = scene.design_variables[i];
    const auto value = values.find(variable.name);
    if (value == values.end()) continue;
    ++found;
    if (!std::isfinite(value->second)) {
      throw std::invalid_argument("design variable '" + variable.name + "': value " +
                                  shortNumber(value->second) + "; expected a finite number");
    }
    add(scene, i, value->second, all);
  }
  if (found != values.size()) refuseUnknown(scene, values);
  return all;
}

std::vector<ComponentFrame> componentFrames(const Scene& scene, const Deviations& deviations,
                                            const ComponentPoses& moved) {
  return FrameBuilder(scene, deviations, moved).take();
}

std::size_t componentIndex(const Scene& scene, const std::string& name) {
  if (name == "world") return ComponentFrame::kWorld;
  for (std::size_t i = 0; i < scene.components.size(); ++i) {
    if (scene.components[i].name == name) return i;
  }
  throw std::invalid_argument("there is no component '" + name + "'");
}

}  // namespace cable_variation
