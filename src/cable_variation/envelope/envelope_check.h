#pragma once

#include <cable_variation/envelope/envelope_generator.h>

namespace cable_variation {

/// The options with their cables listed. Throws std::invalid_argument as generateEnvelope(), for what can be
/// told without a solve.
EnvelopeOptions checkedOptions(const Scene& scene, EnvelopeOptions options);

}  // namespace cable_variation
