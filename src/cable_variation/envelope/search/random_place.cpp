#include <cable_variation/envelope/search/random_place.h>

#include <algorithm>

namespace cable_variation {
namespace {

constexpr std::uint32_t kLearningStream = 5, kRareStream = 6;  // as drawPlace()'s, beside a PointSet's
constexpr std::size_t kMostLikeRare = 1000;                    // rounds are that far apart

}  // namespace

SamplePlace drawPlace(const SampleSpace& space, double from, double to, const CounterRandom& random,
                      std::uint64_t index) {
  RandomRow numbers(random, index);
  SamplePlace place;
  place.time = from + numbers.uniform() * (to - from);
  place.deviations = isDrawnEvenly(index) ? space.tolerances().random(numbers)
                                          : space.tolerances().randomNearLimits(numbers);
  return place;
}

std::vector<SamplePlace> LearningPlaces::ofRound(int round, std::size_t like_rare) const {
  const CounterRandom all_over(seed, kLearningStream), mixing(seed, kRareStream);
  const auto first = static_cast<std::uint64_t>(round) * std::max(count, kMostLikeRare);
  std::vector<SamplePlace> places;
  for (std::size_t i = 0; i < count; ++i) places.push_back(drawPlace(space, from, to, all_over, first + i));
  for (std::size_t i = 0; !rare.empty() && i < std::min(like_rare, kMostLikeRare); ++i) {
    RandomRow numbers(mixing, first + i);
    const auto pick = [&]() -> const SamplePlace& {
      return rare[static_cast<std::size_t>(numbers.uniform() * static_cast<double>(rare.size()))];
    };
    const SamplePlace &one = pick(), &other = pick();
    places.push_back({space.tolerances().offspring(one.deviations, other.deviations, numbers), one.time});
  }
  return places;
}

}  // namespace cable_variation
