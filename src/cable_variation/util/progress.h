#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace cable_variation {

/// How far a long calculation is.
struct Progress {
  /// What runs along: of a measure, over the samples so far [its unit].
  struct Figure {
    std::string measure;
    double mean = 0.0, sigma = 0.0;
  };

  std::string stage;       ///< for a person, such as "containment"
  double share = 0.0;      ///< done, of the whole, 0 to 1
  std::uint64_t done = 0;  ///< equilibria of an envelope, samples of production
  double time = 0.0;       ///< of a motion, reached [s]

  // Of production:
  std::uint64_t wanted = 0;   ///< samples, as far as is known yet
  std::uint64_t snapped = 0;  ///< of those done
  std::uint64_t failed = 0;   ///< without an equilibrium
  std::vector<Figure> figures = {};
};

/// Told now and then, several times a second, by one thread at a time; false: end.
using ProgressObserver = std::function<bool(const Progress&)>;

/// Estimate [s], if what is left goes on as what is done did.
/// @param elapsed since the start [s] @param share done, 0 to 1
/// Not a number while nothing is done.
double timeLeft(double elapsed, double share);

/// Tells an observer how far a calculation is, and ends the calculation when it asks for that. Safe from
/// several threads.
class ProgressReporter {
 public:
  /// @param observer must outlive the reporter; empty: nobody is told
  explicit ProgressReporter(const ProgressObserver& observer) : observer_(observer) {}

  /// Throws Cancelled, from then on always, when the observer asks for an end.
  void operator()(const Progress& progress);

  /// Asks whether to go on, where there is nothing new to tell. Throws as above.
  void check();

 private:
  void ask();

  const ProgressObserver& observer_;
  std::mutex mutex_;
  Progress told_;
  bool ended_ = false;
};

}  // namespace cable_variation
