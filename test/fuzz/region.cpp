#include <cable_variation/envelope/forbidden_region.h>

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cable_variation;
  return acceptsOrRefuses([&] {
    const ForbiddenRegion region = parseRegion(textOf(data, size), "fuzz");
    // what was read is written so that it is read again
    if (parseRegion(regionText(region), "again").pieces.size() != region.pieces.size()) {
      throw std::logic_error("pieces are lost");
    }
  });
}
