// The other side of import_program.h: what is in the programs themselves.
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cable_variation/util/import_program.h>

namespace cable_variation {

namespace {

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

int runImport(int argc, char** argv, std::size_t count,
              const std::function<std::string(const std::vector<std::string>&)>& import,
              std::size_t most_written) {
  const std::vector<std::string> words(argv, argv + argc);
  if (words.size() != 3 + count) return EXIT_FAILURE;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  closeWhatWasInherited();
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, most_written);
  limit(RLIMIT_AS, std::strtoull(argv[1], nullptr, 10));
  limit(RLIMIT_CPU, std::strtoull(argv[2], nullptr, 10));
  std::set_new_handler([] { _exit(static_cast<int>(ImportEnd::out_of_memory)); });
  try {
    return tell(ImportEnd::done, import({words.begin() + 3, words.end()}));
  } catch (const std::exception& error) {
    return tell(ImportEnd::refused, error.what());
  }
}

}  // namespace cable_variation
