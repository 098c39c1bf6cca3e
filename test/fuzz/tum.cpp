#include <cable_variation/scene/tum_file.h>

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cable_variation;
  const MemoryFile file(data, size);
  return acceptsOrRefuses([&] {
    Motion motion;
    readTum(file.path(), motion, InputLimits());
    for (const TimedPose& sample : motion.samples) {
      if (!poseAt(motion, sample.time).position.allFinite()) throw std::logic_error("a pose is not finite");
    }
  });
}
