#pragma once

#include <cable_variation/GenerateEnvelopeFeedback.h>
#include <cable_variation/SimulateVariationFeedback.h>

#include <cable_variation/util/progress.h>

namespace cable_variation_ros {

// How far a run is, as feedback of its action. @param elapsed since it was asked for [s]

void setFeedback(const cable_variation::Progress& progress, double elapsed,
                 cable_variation::GenerateEnvelopeFeedback& feedback);
void setFeedback(const cable_variation::Progress& progress, double elapsed,
                 cable_variation::SimulateVariationFeedback& feedback);

}  // namespace cable_variation_ros
