#pragma once

#include <chrono>
#include <string>

#include <cable_variation/util/progress.h>

namespace cable_variation_command {

/// "  samples      [######..................]  25 %  1,200 of 10,000  about 10 s left"
/// @param elapsed since the start [s]
std::string progressText(const cable_variation::Progress& progress, double elapsed);

/// One line on the terminal that the standard error is, written over again; nothing if it is none.
class StatusLine {
 public:
  StatusLine();
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  void show(const cable_variation::Progress& progress);
  void clear();

 private:
  void write(const std::string& text);

  bool on_terminal_;
  std::size_t width_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace cable_variation_command
