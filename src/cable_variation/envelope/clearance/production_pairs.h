#pragma once  // internal to envelope/

#include <functional>
#include <optional>
#include <vector>

#include <cable_variation/envelope/clearance/clearance_samples.h>

namespace cable_variation {

/// Per distance, the closest of the harnesses that verified an envelope of a share of production and that it
/// holds, Envelope::draws: solved again, each once. None where nothing is to be measured.
///
/// That at least the envelope's share of production is no closer has the confidence that the share itself has
/// been shown with. Of n harnesses k are not held, and at most k of them are closer than the closest that is
/// held: it is at most the (k+1)-th smallest of n independent distances, which bounds a quantile as k of n
/// outside bound a share (David and Nagaraja, Order Statistics, 2003, section 7.2).
/// @param options as the envelope was made with @param check called now and then, by any thread; may throw
std::vector<std::optional<SampleDistance>> closestInProduction(const Scene& scene,
                                                               const EnvelopeOptions& options,
                                                               SampleShapes& shapes,
                                                               const std::vector<ExactDistance>& distances,
                                                               const std::function<void()>& check);

}  // namespace cable_variation
