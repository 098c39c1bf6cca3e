#include <cable_variation/scene_file/urdf_reader.h>

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cable_variation;
  const MemoryFile file(data, size);
  return acceptsOrRefuses([&] {
    const auto no_mesh = [](const std::string& address, const Eigen::Vector3d&) -> LoadedMesh {
      throw std::invalid_argument("mesh '" + address + "' is not there");
    };
    std::vector<std::string> faults, warnings;
    const std::vector<Visual> visuals = readUrdf(file.path(), {}, no_mesh, faults, warnings);
    if (visuals.empty() && faults.empty()) throw std::logic_error("nothing was read, nothing is wrong");
  });
}
