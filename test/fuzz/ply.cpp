#include <cable_variation/geometry/mesh/ply_reader.h>

#include "fuzz_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cable_variation;
  return fuzzMesh([](const std::string& file) { return readPly(file); }, data, size);
}
