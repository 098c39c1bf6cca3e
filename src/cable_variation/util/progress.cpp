#include <cable_variation/util/progress.h>

#include <limits>

#include <cable_variation/util/error.h>

namespace cable_variation {

double timeLeft(double elapsed, double share) {
  if (!(share > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return elapsed * (1.0 - share) / share;
}

void ProgressReporter::operator()(const Progress& progress) {
  if (!observer_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  told_ = progress;
  ask();
}

void ProgressReporter::check() {
  if (!observer_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  ask();
}

void ProgressReporter::ask() {
  if (!ended_) ended_ = !observer_(told_);
  if (ended_) throw Cancelled();
}

}  // namespace cable_variation
