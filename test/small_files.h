#pragma once

#include <csignal>

#include <sys/resource.h>

namespace cable_variation {

/// As long as this lives, no file of this process grows beyond 64 kB: to what writes it is as a full disk,
/// but for the system's words ("File too large").
class SmallFiles {
 public:
  SmallFiles() : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &usual_);
    rlimit small = usual_;
    small.rlim_cur = kLargest;
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &usual_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  static constexpr rlim_t kLargest = 65536;
  void (*handler_)(int);
  rlimit usual_;
};

}  // namespace cable_variation
