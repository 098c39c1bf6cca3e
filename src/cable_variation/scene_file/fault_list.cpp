#include <cable_variation/scene_file/fault_list.h>

#include <algorithm>

#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/readable_text.h>

namespace cable_variation {
namespace {

std::vector<SceneFault> byLine(std::vector<SceneFault> faults) {
  std::stable_sort(faults.begin(), faults.end(),
                   [](const SceneFault& a, const SceneFault& b) { return a.line < b.line; });
  faults.erase(std::unique(faults.begin(), faults.end(),
                           [](const SceneFault& a, const SceneFault& b) {
                             return a.line == b.line && a.message == b.message;
                           }),
               faults.end());
  return faults;
}

}  // namespace

void FaultList::add(int line, const std::string& message) {
  faults_.push_back({file_, line, readableText(message)});
  if (faults_.size() < most_) return;
  faults_.push_back({file_, line,
                     "no more than these " + std::to_string(most_) +
                         " faults are told (the limit faults); the rest of the file was not read"});
  throw Full();
}

void FaultList::warn(int line, const std::string& message) {
  if (warnings_.size() < most_) warnings_.push_back({file_, line, readableText(message)});
}

std::vector<SceneFault> FaultList::sorted() const { return byLine(faults_); }

std::vector<SceneFault> FaultList::sortedWarnings() const { return byLine(warnings_); }

SceneError::SceneError(std::vector<SceneFault> faults)
    : std::invalid_argument([&faults] {
        constexpr std::size_t kMost = 500;  // that anybody reads
        std::string text;
        for (std::size_t i = 0; i < std::min(faults.size(), kMost); ++i) {
          text += (text.empty() ? "" : "\n") + toString(faults[i]);
        }
        if (faults.size() > kMost) text += "\nand " + std::to_string(faults.size() - kMost) + " more";
        return text;
      }()),
      faults_(std::move(faults)) {}

}  // namespace cable_variation
