#include <cable_variation/envelope/envelope_check.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include <cable_variation/envelope/statistical_envelope.h>
#include <cable_variation/scene/deviations.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/util/number_text.h>

namespace cable_variation {
namespace {

void requirePositive(const char* name, double value, const char* unit) {
  if (value > 0.0 && std::isfinite(value)) return;
  std::ostringstream text;
  text << name << ": " << value << unit << "; expected above 0";
  throw std::invalid_argument(text.str());
}

}  // namespace

EnvelopeOptions checkedOptions(const Scene& scene, EnvelopeOptions options) {
  requirePositive("margin", options.margin, " m");
  requirePositive("memory_limit", options.memory_limit, " B");
  if (!(options.from >= 0.0) || !std::isfinite(options.from) || !std::isfinite(options.to))
    throw std::invalid_argument("from and to: expected times of at least 0 s");
  if (options.probability != 0.0) {
    planFor(options.probability, options.verification, 1);  // refuses what is none
    const std::string text = "probability: " + numberText(options.probability);
    if (!options.motions.empty()) {
      throw std::invalid_argument(text +
                                  " over motions; expected no motions, or 0: all that the tolerances allow");
    }
    if (!options.conservative)
      throw std::invalid_argument(text + " without inflation; expected a conservative envelope");
  } else if (options.conservative && options.verification == 0) {
    throw std::invalid_argument("verification: 0 shapes; expected at least 1 for a conservative envelope");
  }
  options.cables = allOrChosen(options.cables, scene.harness.cables.size(), "cable");
  if (options.cables.empty()) throw std::invalid_argument("the scene has no cables");
  for (const std::string& frame : options.frames) componentPose(scene, frame);
  return options;
}

}  // namespace cable_variation
