#include <cable_variation/measures/open_parts.h>

#include <algorithm>
#include <sstream>

#include <cable_variation/geometry/mesh/solids.h>
#include <cable_variation/scene/measure_traits.h>

namespace cable_variation {

std::string openPartWarning(const std::string& name, const PartOpenness& openness) {
  if (!openness.isOpen()) return "";
  std::ostringstream text;
  text.precision(3);
  text << name << " is open: " << openness.edges << " edges of its surface, " << 1e3 * openness.length
       << " mm in all, have no neighbour; what is inside of it is told by its winding number, where that is "
          "within "
       << kClearWinding << " of a whole one, its holes taken as closed from rim to rim";
  return text.str();
}

std::vector<std::string> openPartWarnings(const Scene& scene, const ComponentParts& parts,
                                          const std::vector<std::size_t>& components) {
  std::vector<std::string> warnings;
  for (const std::size_t component : components) {
    const DistancePart* part = parts.find(component);
    if (part == nullptr || !part->openness().isOpen()) continue;
    warnings.push_back(
        openPartWarning("component '" + scene.components[component].name + "'", part->openness()));
  }
  return warnings;
}

PartOpenness ComponentOpenness::of(const Component& component) {
  std::vector<std::shared_ptr<const TriangleMesh>> meshes;
  for (const Visual& visual : component.visuals) meshes.push_back(visual.mesh);
  const auto known = known_.find(component.name);
  if (known != known_.end() && known->second.meshes == meshes) return known->second.openness;
  const TriangleMesh merged = mergedMesh(component);
  PartOpenness openness;
  if (!merged.triangles.empty()) {
    const Solids solids(merged);
    openness = {solids.rim_edges, solids.rim_length};
  }
  known_[component.name] = {std::move(meshes), openness};
  return openness;
}

std::vector<std::size_t> componentsMeasured(const Scene& scene, const std::vector<std::size_t>& measures) {
  std::vector<std::size_t> components;
  for (const std::size_t index : measures) {
    const Measure& measure = scene.measures.at(index);
    if (!traitsOf(measure.type).clearance || !measure.component) continue;
    for (const std::size_t body : measuredComponents(scene, *measure.component)) components.push_back(body);
  }
  std::sort(components.begin(), components.end());
  components.erase(std::unique(components.begin(), components.end()), components.end());
  return components;
}

std::string undecidedNote(const std::string& component, ClosestPair::Side side, double winding) {
  if (side != ClosestPair::Side::undecided) return "";
  std::ostringstream text;
  text.precision(2);
  text << "it cannot be told whether the cable is inside '" << component
       << "', which is open there (winding number " << winding << "): the value counts as if it were outside";
  return text.str();
}

}  // namespace cable_variation
