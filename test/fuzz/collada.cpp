// What is looked at before an importer sees it; the importer is not ours and has a process of its own.
#include <cable_variation/geometry/mesh/collada_check.h>

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cable_variation;
  return acceptsOrRefuses([&] { checkCollada(textOf(data, size)); });
}
