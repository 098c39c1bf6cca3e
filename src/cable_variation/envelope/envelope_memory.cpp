#include <cable_variation/envelope/envelope_memory.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <tbb/task_arena.h>

#include <cable_variation/envelope/envelope_generator.h>
#include <cable_variation/envelope/envelope_tightness.h>
#include <cable_variation/envelope/statistical_envelope.h>
#include <cable_variation/geometry/mesh/box.h>

namespace cable_variation {
namespace {

// Measured: what a stretch of a phase takes as seen from one frame, with the hull in the making [B]; a solver
// per element, with its factors [B].
constexpr double kPiece = 12e3, kElement = 12e3;
// Of a shape, for what each block of memory takes beside its content, and for what there is once: its place,
// coordinates, how far they are trusted, where they have been looked at [B].
constexpr double kBlock = 16.0, kOnce = 1000.0, kByCoordinate = 60.0;
// Measured: what lies free between blocks that grow while others stay.
constexpr double kGaps = 1.25;
// A search that snaps has its shapes in so many clusters, and some more.
constexpr std::size_t kClusters = 8;
// Shapes that a search must be able to keep to be of use.
constexpr double kFewestShapes = 64.0;
constexpr double kMost = 1e9;  // of whatever is counted

double count(std::size_t number) { return static_cast<double>(number); }

std::size_t countWithin(double limit, double each) {
  return static_cast<std::size_t>(std::clamp(limit / each, 0.0, kMost));
}

double threads() { return static_cast<double>(tbb::this_task_arena::max_concurrency()); }

template <typename Value>
[[noreturn]] void refuse(const char* field, const Value& value, double needed, double share, double limit,
                         const std::string& expected) {
  std::ostringstream text;
  text << field << ": " << value << " would take " << memoryText(needed) << "; allowed are "
       << memoryText(share * limit) << " of the limit of " << memoryText(limit) << ": expected " << expected;
  throw std::invalid_argument(text.str());
}

Box boxAround(const Equilibrium& design) {
  Box box;
  for (const CableShape& shape : design.shapes) {
    for (const ShapePoint& point : shape.points) {
      box.add(point.pose.position - Eigen::Vector3d::Constant(shape.radius));
      box.add(point.pose.position + Eigen::Vector3d::Constant(shape.radius));
    }
  }
  return box;
}

}  // namespace

EnvelopeMemory::EnvelopeMemory(const StretchShape& of, const Equilibrium& design) {
  std::size_t elements = 0;
  for (const CableShape& each : design.shapes) elements += each.points.size();
  const std::size_t stretches = of.radius.size(), frames = of.rates.size();
  const double coordinates = count(static_cast<std::size_t>(of.rates.front().cols()) / (2 * stretches));
  for (const auto& rates : of.rates) shape += sizeof(float) * count(static_cast<std::size_t>(rates.size()));
  for (const auto& ends : of.ends) shape += sizeof(double) * count(static_cast<std::size_t>(ends.size()));
  // as seen from the world alone
  for (const auto& points : of.control.front())
    shape += sizeof(Eigen::Vector3d) * count(points.capacity()) + sizeof(points) + kBlock;
  shape += count(frames) * (sizeof(Pose) + 2.0 * kBlock) + sizeof(double) * count(stretches) + kOnce +
           kByCoordinate * coordinates;
  shape *= kGaps;
  hulls = count(stretches) * count(frames) * kPiece;
  phase = hulls + kElement * count(elements) + 2.0 * shape;
}

double EnvelopeMemory::ofSearch(std::size_t shapes, std::size_t clusters) const {
  return count(shapes) * shape + count(clusters) * hulls;
}

std::size_t EnvelopeMemory::mostPhases(double limit) const {
  return std::max<std::size_t>(1, countWithin(kForPhases * limit, phase));
}

std::size_t EnvelopeMemory::mostShapes(double limit, std::size_t phases) const {
  const double of_all = (phases == 1 ? kForSearches + kForPhases : kForSearches) * limit;
  const double each = of_all / std::min(threads(), count(phases));
  return countWithin(std::max(0.0, each - ofSearch(0, kClusters)), shape);
}

void refuseMoreThanMemory(const EnvelopeOptions& options, const EnvelopeMemory& memory,
                          const Equilibrium& design) {
  const double limit = options.memory_limit;
  const double searches = kFewestShapes * threads() * memory.shape;
  if (searches > EnvelopeMemory::kForSearches * limit) {
    refuse("variables", options.variables.size(), searches, EnvelopeMemory::kForSearches, limit,
           "fewer, or fewer cables");
  }
  // of each shape that verifies a share of production, how far it sticks out; in the worst case they are only
  // counted
  const double row = options.probability > 0.0 ? sizeof(double) * kMostLooks : 0.0;
  if (row * count(options.verification) > EnvelopeMemory::kForRandomShapes * limit) {
    refuse("verification_shapes", options.verification, row * count(options.verification),
           EnvelopeMemory::kForRandomShapes, limit,
           "at most " + std::to_string(countWithin(EnvelopeMemory::kForRandomShapes * limit, row)));
  }
  if (options.tightness == 0 || !(options.voxel > 0.0)) return;
  const double voxels = tightnessMemory(boxAround(design), options.voxel);
  if (voxels > EnvelopeMemory::kForVoxels * limit) {
    std::ostringstream value, least;
    value << options.voxel << " m, around the design alone,";
    least << "about " << options.voxel * std::cbrt(voxels / (EnvelopeMemory::kForVoxels * limit))
          << " m at least";
    refuse("tightness_voxel", value.str(), voxels, EnvelopeMemory::kForVoxels, limit, least.str());
  }
}

std::string memoryText(double bytes) {
  constexpr double kThousand = 1e3, kHundred = 100.0;
  const char* const units[] = {"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= kThousand && unit + 1 < std::size(units)) {
    bytes /= kThousand;
    ++unit;
  }
  std::ostringstream text;
  text.precision(bytes >= kHundred ? 3 : 2);
  text << bytes << ' ' << units[unit];
  return text.str();
}

}  // namespace cable_variation
