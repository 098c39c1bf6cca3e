#pragma once

// FCL's distance between moved objects, for FCL from 0.6 on, and 0.5.

#if __has_include(<fcl/narrowphase/distance.h>)
#include <fcl/narrowphase/distance.h>
#else
#include <fcl/distance.h>
#endif

namespace cable_variation::fcl_types {

#if __has_include(<fcl/narrowphase/distance.h>)
using Object = fcl::CollisionObjectd;
using DistanceRequest = fcl::DistanceRequestd;
using DistanceResult = fcl::DistanceResultd;
#else
using Object = fcl::CollisionObject;
using DistanceRequest = fcl::DistanceRequest;
using DistanceResult = fcl::DistanceResult;
#endif

}  // namespace cable_variation::fcl_types
