#pragma once

#include <memory>
#include <vector>

#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/scene/merged_mesh.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// A component with triangles that a measure looks at.
struct MeasuredBody {
  std::size_t component;
  const DistancePart* part;
};

/// The components that a distance to `component` is measured to: of a robot's root all its links that have
/// triangles, else the component alone.
std::vector<std::size_t> measuredComponents(const Scene& scene, std::size_t component);

/// Components of a scene made ready for distances, which is costly: copies share what is prepared. const
/// members may be called by several threads.
class ComponentParts {
 public:
  /// Makes a component's part ready, unless it is here or in `known` made of the same meshes. Throws
  /// std::invalid_argument that names the component: it has no triangles.
  void prepare(const Scene& scene, std::size_t component, const ComponentParts& known);
  /// All components that have triangles, likewise.
  void prepareAll(const Scene& scene, const ComponentParts& known);

  /// Of a component by its index; null: not prepared.
  const DistancePart* find(std::size_t component) const;

 private:
  struct Prepared;
  std::vector<std::shared_ptr<const Prepared>> parts_;  // per component
};

}  // namespace cable_variation
