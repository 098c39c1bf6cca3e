// collada_importer MEMORY SECONDS XML_PARTS TRIANGLES: reads a COLLADA document from standard input and
// writes its triangles (imported_mesh.h), or what is wrong with it, to standard output. A process of its own,
// because the libraries that read it crash on some files and take all memory on others (import_program.h).

#include <cerrno>
#include <cstdlib>
#include <string>
#include <vector>

#include <unistd.h>

#include <cable_variation/geometry/mesh/collada_check.h>
#include <cable_variation/geometry/mesh/collada_importer/assimp_import.h>
#include <cable_variation/util/import_program.h>

namespace {

std::string readAll() {
  std::string text;
  for (std::vector<char> piece(std::size_t{1} << 20U);;) {
    const ssize_t some = read(STDIN_FILENO, piece.data(), piece.size());
    if (some < 0 && errno == EINTR) continue;
    if (some <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(some));
  }
}

std::string trianglesOf(const std::vector<std::string>& limits) {
  using namespace cable_variation;
  const std::string document = readAll();
  checkCollada(document, std::strtoull(limits[0].c_str(), nullptr, 10));
  return bytesOf(importCollada(document, std::strtoull(limits[1].c_str(), nullptr, 10)));
}

}  // namespace

int main(int argc, char** argv) { return cable_variation::runImport(argc, argv, 2, trianglesOf); }
