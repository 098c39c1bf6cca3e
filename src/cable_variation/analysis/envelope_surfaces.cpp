#include <cable_variation/analysis/envelope_surfaces.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <cable_variation/envelope/envelope_memory.h>

namespace cable_variation {

namespace {

/// The surface of all pieces, or of one cable's.
OuterSurface surfaceOf(const std::vector<EnvelopePiece>& pieces, std::optional<std::size_t> cable,
                       const OuterSurfaceOptions& options) {
  std::vector<const RoundedHull*> bodies;
  for (const EnvelopePiece& piece : pieces) {
    if (!cable || piece.cable == *cable) bodies.push_back(&piece.body);
  }
  return outerSurface(bodies, options);
}

std::vector<CableSurface> surfacesByCable(const Envelope& envelope, const OuterSurface& whole,
                                          OuterSurfaceOptions options) {
  if (envelope.cables.size() == 1) return {CableSurface{envelope.cables.front(), whole.mesh}};
  options.triangles /= envelope.cables.size();
  options.memory_limit /= static_cast<double>(envelope.cables.size());
  std::vector<CableSurface> surfaces;
  for (const std::size_t cable : envelope.cables) {
    surfaces.push_back({cable, surfaceOf(envelope.frames.front().pieces, cable, options).mesh});
  }
  return surfaces;
}

}  // namespace

EnvelopeSurfaces envelopeSurfaces(const EnvelopeTask& task, const Envelope& envelope, bool by_cable,
                                  const std::function<void()>& check) {
  OuterSurfaceOptions options;
  options.excess = task.mesh_excess;
  options.threads = task.options.threads;
  options.memory_limit = task.mesh_memory;
  options.check = check;
  EnvelopeSurfaces surfaces;
  surfaces.whole = surfaceOf(envelope.frames.front().pieces, std::nullopt, options);
  if (by_cable) surfaces.by_cable = surfacesByCable(envelope, surfaces.whole, options);
  return surfaces;
}

void refuseFinerMeshThanMemory(const EnvelopeTask& task, const Scene& scene) {
  if (!(task.mesh_excess > 0.0)) return;
  double area = 0.0, thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.harness.cables.size(); ++i) {
    const auto& chosen = task.options.cables;
    if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), i) == chosen.end()) continue;
    const Cable& cable = scene.harness.cables[i];
    double radius = std::numeric_limits<double>::infinity();
    for (const auto& part : cable.sections) radius = std::min(radius, part.section.radius);
    area += 2.0 * M_PI * radius * cable.length;
    thinnest = std::min(thinnest, radius);
  }
  const double needed = outerSurfaceMemory(area, thinnest, task.mesh_excess);
  if (needed <= task.mesh_memory) return;
  std::ostringstream text;
  text << "mesh_excess: is " << task.mesh_excess << " m, which would take " << memoryText(needed)
       << " for the nominal cables alone; allowed for the mesh are " << memoryText(task.mesh_memory)
       << " of ~memory_limit: expected " << finestExcess(area, thinnest, task.mesh_memory)
       << " m at least, or 0: its default";
  throw std::invalid_argument(text.str());
}

}  // namespace cable_variation
