#pragma once

#include <ctime>

namespace cable_variation::test {

/// The processor's time since it was made, of all threads of the test: other than the clock on the wall it
/// does not depend on what else the machine does. For work that would take minutes or for ever if it were not
/// bounded.
class CpuTime {
 public:
  double seconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double start_ = now();
};

}  // namespace cable_variation::test
