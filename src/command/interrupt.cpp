#include <command/interrupt.h>

#include <csignal>

namespace cable_variation_command {

namespace {

volatile std::sig_atomic_t was_interrupted = 0;

void count(int signal) {
  was_interrupted = 1;
  std::signal(signal, SIG_DFL);  // who is impatient asks again
}

}  // namespace

void countInterrupts() {
  std::signal(SIGINT, count);
  std::signal(SIGTERM, count);
}

bool interrupted() { return was_interrupted != 0; }

}  // namespace cable_variation_command
