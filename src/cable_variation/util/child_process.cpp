#include <cable_variation/util/child_process.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cable_variation/util/error.h>

extern char** environ;  // NOLINT: POSIX's name

namespace cable_variation {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const std::string& program, int error) {
  throw FileError("the program '" + program + "' cannot be run: " + std::strerror(error));
}

// A file descriptor, closed in the end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }
  void set(int number) {
    close();
    number_ = number;
  }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

// 0, or what the system says.
int fill(int file, std::string_view contents) {
  while (!contents.empty()) {
    const ssize_t some = ::write(file, contents.data(), contents.size());
    if (some < 0 && errno == EINTR) continue;
    if (some < 0) return errno;
    contents.remove_prefix(static_cast<std::size_t>(some));
  }
  return ::lseek(file, 0, SEEK_SET) < 0 ? errno : 0;
}

// Starts it with signals as a program expects them, whatever this process has made of them.
int spawn(pid_t& child, const std::string& program, const std::vector<std::string>& arguments, int input,
          int output) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF));
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int error = ::posix_spawn(&child, program.c_str(), &files, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

// Reads until the program ends its output, has written too much, or its time is up.
ChildRun::End readAll(int pipe, Clock::time_point until, std::size_t most, std::string& output) {
  constexpr std::size_t kPiece = std::size_t{1} << 16U;
  std::vector<char> piece(kPiece);
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) return ChildRun::End::took_too_long;
    pollfd ready{pipe, POLLIN, 0};
    if (::poll(&ready, 1, static_cast<int>(std::min<long long>(left, 1000))) <= 0) continue;
    const ssize_t some = ::read(pipe, piece.data(), piece.size());
    if (some < 0 && errno == EINTR) continue;
    if (some <= 0) return ChildRun::End::exited;
    if (output.size() + static_cast<std::size_t>(some) > most) return ChildRun::End::wrote_too_much;
    output.append(piece.data(), static_cast<std::size_t>(some));
  }
}

// Its status; waits for it until then. False: it still runs.
bool waitUntil(pid_t child, Clock::time_point until, int& status) {
  for (;;) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) return true;
    if (ended < 0 && errno != EINTR) {  // somebody else has waited for it: its output tells
      status = 0;
      return true;
    }
    if (Clock::now() >= until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace

ChildRun runChild(const std::string& program, const std::vector<std::string>& arguments,
                  std::string_view input, double seconds, std::size_t most_output) {
  const auto until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  const Descriptor file(::memfd_create("input", MFD_CLOEXEC));
  if (file.get() < 0) fail(program, errno);
  if (const int error = fill(file.get(), input)) fail(program, error);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) fail(program, errno);
  const Descriptor from(ends[0]);
  Descriptor to(ends[1]);
  pid_t child = 0;
  if (const int error = spawn(child, program, arguments, file.get(), to.get())) fail(program, error);
  to.close();

  ChildRun run;
  int status = 0;
  try {
    run.end = readAll(from.get(), until, most_output, run.output);
  } catch (...) {  // no memory for what it says
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    throw;
  }
  if (run.end == ChildRun::End::exited && !waitUntil(child, until, status)) {
    run.end = ChildRun::End::took_too_long;
  }
  if (run.end != ChildRun::End::exited) {
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
  } else if (WIFSIGNALED(status)) {
    run.end = ChildRun::End::killed_by_signal;
    run.code = WTERMSIG(status);
  } else {
    run.code = WEXITSTATUS(status);
  }
  return run;
}

std::string signalName(int signal) {
  const char* const name = ::strsignal(signal);
  return name != nullptr ? name : "signal " + std::to_string(signal);
}

}  // namespace cable_variation
