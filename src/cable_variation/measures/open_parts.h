#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <cable_variation/measures/component_parts.h>

namespace cable_variation {

/// What is to be known of parts whose surface is not closed: inside and outside are told by a winding number,
/// if at all (geometry/distance.h). One sentence for each that is open.
/// @param components by index; those that are not prepared say nothing
std::vector<std::string> openPartWarnings(const Scene& scene, const ComponentParts& parts,
                                          const std::vector<std::size_t>& components);

/// Of a part by itself; empty: it is closed. @param name as it is called, with its quotes
std::string openPartWarning(const std::string& name, const PartOpenness& openness);

/// What keeps components from being closed, each looked at once as long as its meshes stay the same.
class ComponentOpenness {
 public:
  PartOpenness of(const Component& component);

 private:
  struct Known {
    std::vector<std::shared_ptr<const TriangleMesh>> meshes;
    PartOpenness openness;
  };
  std::map<std::string, Known> known_;
};

/// The components that measures (indices into Scene::measures) look at, ascending.
std::vector<std::size_t> componentsMeasured(const Scene& scene, const std::vector<std::size_t>& measures);

/// Why a distance to an open part may not be what it seems: "it cannot be told whether ..."; empty unless
/// ClosestPair::Side::undecided.
std::string undecidedNote(const std::string& component, ClosestPair::Side side, double winding);

}  // namespace cable_variation
