#include <cable_variation/util/name_list.h>

#include <algorithm>
#include <array>

namespace cable_variation {
namespace {

// Edit distance: letters replaced, put in, left out, or swapped with their neighbour.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] =
          std::min({d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), d[i - 1][j] + 1, d[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

// How unlike two words are: by distance, then by first letter, then by length.
std::array<std::size_t, 3> unlikeness(const std::string& a, const std::string& b) {
  return {editDistance(a, b), std::size_t{a.empty() || b.empty() || a.front() != b.front()},
          std::max(a.size(), b.size()) - std::min(a.size(), b.size())};
}

}  // namespace

std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongest = 64;  // of a name worth comparing
  constexpr std::size_t kMany = 2000;   // that it is not worth the time to look through
  constexpr std::size_t kFew = 12;      // that a message may list
  const std::string* best = nullptr;
  std::array<std::size_t, 3> least{std::max<std::size_t>(1, std::min<std::size_t>(3, name.size() / 3)) + 1, 0,
                                   0};
  if (candidates.size() > kMany) return "";
  for (const std::string& candidate : candidates) {
    if (std::max(name.size(), candidate.size()) - std::min(name.size(), candidate.size()) > least[0])
      continue;
    if (name.size() > kLongest || candidate.size() > kLongest) continue;
    const auto difference = unlikeness(name, candidate);
    if (difference < least && difference[0] < candidate.size()) {
      best = &candidate;
      least = difference;
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

}  // namespace cable_variation
