#include <cable_variation/simulation/simulation_options.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include <cable_variation/tolerances/point_set.h>
#include <cable_variation/util/chosen_indices.h>

namespace cable_variation {

namespace {

template <typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream stream;
  (stream << ... << parts);
  throw std::invalid_argument(stream.str());
}

}  // namespace

SimulationOptions checkedOptions(const Scene& scene, SimulationOptions options) {
  if (options.variables.empty()) refuse("no design variables: expected at least one that varies");
  if (options.samples < 1 || options.samples > kMostSamples)
    refuse("samples: ", options.samples, "; expected 1 to ", kMostSamples);
  if (!(options.sigma_error >= 0.0 && options.sigma_error < 1.0))
    refuse("sigma_error: ", options.sigma_error, "; expected below 1, and above 0 or 0: the count is given");
  if (options.first_sample > kMostSamples - options.samples)
    refuse("first_sample: ", options.first_sample, "; expected at most ", kMostSamples - options.samples,
           " with ", options.samples, " samples");
  if (options.first_sample > 0 && options.sigma_error > 0.0)
    refuse("first_sample: ", options.first_sample, "; expected 0 with a sigma_error");
  if (options.first_sample > 0 && options.sampler == SamplerType::latin_hypercube)
    refuse(
        "sampler latin_hypercube: its samples are of a count; expected monte_carlo or sobol with a "
        "first_sample");
  if (options.sigma_error > 0.0 && options.sampler == SamplerType::latin_hypercube)
    refuse(
        "sampler latin_hypercube: its samples are of a count; expected monte_carlo or sobol with a "
        "sigma_error");
  if (!(options.confidence > 0.0 && options.confidence < 1.0))
    refuse("confidence: ", options.confidence, "; expected above 0, below 1");
  if (options.sections < 2) refuse("sections: ", options.sections, "; expected at least 2");
  if (options.most_times < 1) refuse("most_times: 0; expected at least 1");
  if (!(options.from >= 0.0) || !(options.to >= options.from) || !std::isfinite(options.to))
    refuse("from ", options.from, " s to ", options.to, " s; expected times in order, of at least 0");
  if (scene.harness.cables.empty()) refuse("the scene has no cables");
  options.measures = allOrChosen(options.measures, scene.measures.size(), "measure");
  return options;
}

}  // namespace cable_variation
