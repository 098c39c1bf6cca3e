#include <command/status_line.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <unistd.h>

#include <cable_variation/util/number_text.h>

namespace cable_variation_command {

namespace {

constexpr std::size_t kWidth = 100;  // of the line, in characters
constexpr int kBar = 24;

std::string bar(double share) {
  const double done = std::clamp(share, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(std::lround(kBar * done));
  char percent[16];
  std::snprintf(percent, sizeof percent, "] %3.0f %%", 100.0 * done);
  return "[" + std::string(full, '#') + std::string(kBar - full, '.') + percent;
}

std::string timeText(double seconds) {
  struct Unit {
    const char* name;
    double size;
  };
  constexpr double kEnough = 100.0;
  for (const Unit& unit : {Unit{" s", 1.0}, Unit{" min", 60.0}}) {
    if (seconds < kEnough * unit.size)
      return std::to_string(std::lround(std::ceil(seconds / unit.size))) + unit.name;
  }
  return std::to_string(std::lround(std::ceil(seconds / 3600.0))) + " h";
}

}  // namespace

std::string progressText(const cable_variation::Progress& progress, double elapsed) {
  constexpr std::size_t kStage = 11;
  std::string text = "  " + progress.stage;
  text += std::string(progress.stage.size() < kStage ? kStage - progress.stage.size() : 0, ' ');
  if (progress.share > 0.0) text += " " + bar(progress.share);
  if (progress.wanted > 0)
    text += "  " + std::to_string(progress.done) + " of " + std::to_string(progress.wanted);
  if (progress.snapped > 0) text += "  " + std::to_string(progress.snapped) + " snapped";
  if (progress.failed > 0) text += "  " + std::to_string(progress.failed) + " failed";
  if (progress.time > 0.0) text += "  t = " + cable_variation::numberText(progress.time, 4) + " s";
  const double left = cable_variation::timeLeft(elapsed, progress.share);
  if (std::isfinite(left)) text += "  about " + timeText(left) + " left";
  return text.substr(0, kWidth);
}

StatusLine::StatusLine() : on_terminal_(::isatty(STDERR_FILENO) == 1) {}

StatusLine::~StatusLine() { clear(); }

void StatusLine::show(const cable_variation::Progress& progress) {
  if (!on_terminal_ || progress.stage.empty()) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  write(progressText(progress, elapsed.count()));
}

void StatusLine::clear() {
  if (width_ == 0) return;
  write("");
  std::fputc('\r', stderr);
}

void StatusLine::write(const std::string& text) {
  const std::string blanks(width_ > text.size() ? width_ - text.size() : 0, ' ');
  std::fprintf(stderr, "\r%s%s", text.c_str(), blanks.c_str());
  std::fflush(stderr);
  width_ = text.size();
}

}  // namespace cable_variation_command
