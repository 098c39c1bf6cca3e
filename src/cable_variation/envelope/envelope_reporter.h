#pragma once

#include <mutex>

#include <cable_variation/envelope/envelope_generator.h>
#include <cable_variation/util/error.h>

namespace cable_variation {

/// Reports progress, one thread at a time, and throws Cancelled when asked to stop.
class EnvelopeReporter {
 public:
  /// The observer must outlive it.
  explicit EnvelopeReporter(const EnvelopeObserver& observer) : observer_(observer) {}

  void operator()(const EnvelopeProgress& progress) {
    if (!observer_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!stopped_) stopped_ = !observer_(progress);
    if (stopped_) throw Cancelled();
  }

 private:
  const EnvelopeObserver& observer_;
  std::mutex mutex_;
  bool stopped_ = false;
};

}  // namespace cable_variation
