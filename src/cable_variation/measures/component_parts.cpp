#include <cable_variation/measures/component_parts.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <cable_variation/scene/moving_components.h>

namespace cable_variation {

namespace {

bool hasTriangles(const Component& component) {
  return std::any_of(component.visuals.begin(), component.visuals.end(),
                     [](const Visual& visual) { return visual.mesh && !visual.mesh->triangles.empty(); });
}

}  // namespace

std::vector<std::size_t> measuredComponents(const Scene& scene, std::size_t component) {
  std::vector<std::size_t> bodies = bodiesOf(scene, component);
  if (bodies.size() == 1) return bodies;
  bodies.erase(std::remove_if(bodies.begin(), bodies.end(),
                              [&](std::size_t body) { return !hasTriangles(scene.components[body]); }),
               bodies.end());
  return bodies;
}

// With what it was made from: as long as that is the same it can be used again.
struct ComponentParts::Prepared {
  std::vector<std::pair<std::shared_ptr<const TriangleMesh>, Pose>> of;
  std::shared_ptr<const DistancePart> part;

  Prepared(const Component& component, std::shared_ptr<const DistancePart> known)
      : part(known ? std::move(known) : std::make_shared<const DistancePart>(mergedMesh(component))) {
    for (const Visual& visual : component.visuals) of.emplace_back(visual.mesh, visual.pose);
  }
  bool fits(const Component& component) const {
    if (component.visuals.size() != of.size()) return false;
    for (std::size_t i = 0; i < of.size(); ++i) {
      const Visual& visual = component.visuals[i];
      if (visual.mesh != of[i].first || visual.pose.position != of[i].second.position ||
          visual.pose.orientation.coeffs() != of[i].second.orientation.coeffs()) {
        return false;
      }
    }
    return true;
  }
};

void ComponentParts::prepare(const Scene& scene, std::size_t component, const ComponentParts& known) {
  const Component& of = scene.components.at(component);
  parts_.resize(std::max(parts_.size(), scene.components.size()));
  if (parts_[component] && parts_[component]->fits(of)) return;
  for (const auto& part : known.parts_) {
    if (!part || !part->fits(of)) continue;
    parts_[component] = part;
    return;
  }
  try {
    const auto touched = scene.contact_parts.find(component);
    parts_[component] = std::make_shared<const Prepared>(
        of, touched == scene.contact_parts.end() ? nullptr : touched->second);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("component '" + of.name + "': " + error.what());
  }
}

void ComponentParts::prepareAll(const Scene& scene, const ComponentParts& known) {
  for (std::size_t i = 0; i < scene.components.size(); ++i) {
    if (hasTriangles(scene.components[i])) prepare(scene, i, known);
  }
}

const DistancePart* ComponentParts::find(std::size_t component) const {
  return component < parts_.size() && parts_[component] ? parts_[component]->part.get() : nullptr;
}

}  // namespace cable_variation
