#include <cable_variation/scene_file/scene_reader.h>

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cable_variation;
  const MemoryFile file(data, size);
  return acceptsOrRefuses([&] { readScene(file.path(), [](const std::string&) { return std::string(); }); });
}
