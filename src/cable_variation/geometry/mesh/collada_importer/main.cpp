// collada_importer MEMORY SECONDS XML_PARTS TRIANGLES: reads a COLLADA document from standard input and
// writes its triangles (imported_mesh.h), or what is wrong with it, to standard output. A process of its own,
// because the libraries that read it crash on some files and take all memory on others: within these bounds
// [B, s], with nothing open that its parent has open, and gone with it.

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cable_variation/geometry/mesh/collada_check.h>
#include <cable_variation/geometry/mesh/collada_importer/assimp_import.h>

namespace {

using namespace cable_variation;

void limit(int what, rlim_t most) {
  const rlimit bound{most, most};
  setrlimit(static_cast<__rlimit_resource>(what), &bound);
}

void closeWhatWasInherited() {
  std::vector<int> open;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", ignored)) {
    open.push_back(std::atoi(entry.path().filename().c_str()));
  }
  for (const int file : open) {
    if (file > STDERR_FILENO) close(file);
  }
}

std::string readAll() {
  std::string text;
  for (std::vector<char> piece(std::size_t{1} << 20U);;) {
    const ssize_t some = read(STDIN_FILENO, piece.data(), piece.size());
    if (some < 0 && errno == EINTR) continue;
    if (some <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(some));
  }
}

int tell(ImportEnd end, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t some = write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (some < 0 && errno == EINTR) continue;
    if (some < 0) return EXIT_FAILURE;
    bytes.remove_prefix(static_cast<std::size_t>(some));
  }
  return static_cast<int>(end);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return EXIT_FAILURE;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  closeWhatWasInherited();
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_AS, std::strtoull(argv[1], nullptr, 10));
  limit(RLIMIT_CPU, std::strtoull(argv[2], nullptr, 10));
  std::set_new_handler([] { _exit(static_cast<int>(ImportEnd::out_of_memory)); });
  try {
    const std::string document = readAll();
    checkCollada(document, std::strtoull(argv[3], nullptr, 10));
    return tell(ImportEnd::mesh, bytesOf(importCollada(document, std::strtoull(argv[4], nullptr, 10))));
  } catch (const std::exception& error) {
    return tell(ImportEnd::refused, error.what());
  }
}
