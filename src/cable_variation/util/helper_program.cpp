#include <cable_variation/util/helper_program.h>

#include <filesystem>
#include <vector>

#include <dlfcn.h>
#include <unistd.h>

#include <cable_variation/util/error.h>
#include <cable_variation/util/name_list.h>

namespace cable_variation {

std::string helperProgram(const std::string& name) {
  namespace fs = std::filesystem;
  std::vector<std::string> places;
  std::error_code ignored;
  Dl_info library{};
  // the file that this function is in: the library's, or the program's that it is linked to
  if (::dladdr(reinterpret_cast<const void*>(&helperProgram), &library) != 0 && library.dli_fname) {
    const fs::path folder = fs::weakly_canonical(library.dli_fname, ignored).parent_path();
    places.push_back(folder / "cable_variation" / name);
  }
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  if (!program.empty()) places.push_back(program.parent_path() / name);
  places.push_back(fs::path(helperBuildDirectory()) / name);
  for (const std::string& place : places) {
    if (fs::is_regular_file(place, ignored) && ::access(place.c_str(), X_OK) == 0) return place;
  }
  throw FileError("the program '" + name + "' was not found; looked for " + joined(places));
}

}  // namespace cable_variation
