#pragma once

#include <cable_variation/harness/topology.h>

namespace cable_variation {

/// How short a span may become that a sliding clip ends [m]: a small share of the clip's room, which is
/// between the next stations that do not slide; less than the span has where the scene places the clip. 0 for
/// a span that no clip slides on.
double leastLength(const Harness& harness, const Topology& topology, const Span& span);

}  // namespace cable_variation
