#pragma once

#include <vector>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation::bench {

/// A case of test/data/reference: the harness, and its centreline in the continuum.
struct ReferenceCase {
  Harness harness;
  std::vector<double> arc_lengths;
  std::vector<Eigen::Vector3d> positions;
};

/// Case H or W. Throws std::runtime_error when its file cannot be read.
ReferenceCase referenceCase(char name);

/// The largest distance between a solved cable and the continuum's [m].
double deviation(const ReferenceCase& reference, const CableShape& shape);

}  // namespace cable_variation::bench
