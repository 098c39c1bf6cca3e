#include <cable_variation/scene/fault_list.h>

#include <algorithm>
#include <numeric>

namespace cable_variation {
namespace {

// Levenshtein's edit distance.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

void FaultList::add(int line, const std::string& message) { faults_.push_back({file_, line, message}); }

std::vector<SceneFault> FaultList::sorted() const {
  std::vector<SceneFault> faults = faults_;
  std::stable_sort(faults.begin(), faults.end(),
                   [](const SceneFault& a, const SceneFault& b) { return a.line < b.line; });
  faults.erase(std::unique(faults.begin(), faults.end(),
                           [](const SceneFault& a, const SceneFault& b) {
                             return a.line == b.line && a.message == b.message;
                           }),
               faults.end());
  return faults;
}

std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongest = 64;  // of a name worth comparing
  constexpr std::size_t kFew = 12;      // that a message may list
  const std::string* best = nullptr;
  std::size_t best_distance = std::max<std::size_t>(1, std::min<std::size_t>(3, name.size() / 3)) + 1;
  for (const std::string& candidate : candidates) {
    if (name.size() > kLongest || candidate.size() > kLongest) continue;
    const std::size_t distance = editDistance(name, candidate);
    if (distance < best_distance) {
      best = &candidate;
      best_distance = distance;
    }
  }
  if (best) return "; did you mean '" + *best + "'?";
  if (candidates.empty() || candidates.size() > kFew) return "";
  return "; known: " + joined(candidates);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

SceneError::SceneError(std::vector<SceneFault> faults)
    : std::invalid_argument([&faults] {
        std::string text;
        for (const SceneFault& fault : faults) {
          if (!text.empty()) text += '\n';
          text += fault.file;
          if (fault.line > 0) text += ':' + std::to_string(fault.line);
          text += ": " + fault.message;
        }
        return text;
      }()),
      faults_(std::move(faults)) {}

}  // namespace cable_variation
