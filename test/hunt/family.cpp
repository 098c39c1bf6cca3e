#include <hunt/family.h>

#include <stdexcept>

namespace cable_variation::hunt {

const std::vector<Family>& families() {
  static const std::vector<Family> list = {
      {"two_ends", makeTwoEnds},           {"any_orientation", makeAnyOrientation},
      {"several_clips", makeSeveralClips}, {"sliding_near_end", makeSlidingNearEnd},
      {"two_slides", makeTwoSlides},       {"preformed", makePreformed},
      {"free_ends", makeFreeEnds},         {"heavy_tip", makeHeavyTip},
      {"thin_wire", makeThinWire},         {"chain", makeChain},
      {"branches", makeBranches},          {"loop", makeLoop},
      {"flipped_ends", makeFlippedEnds},   {"twist_hint", makeTwistHint},
      {"stiff_soft", makeStiffSoft},       {"pitchfork", makePitchfork},
      {"long_slack", makeLongSlack},       {"big", makeBig, 4},
      {"long_soft", makeLongSoft},         {"slender", makeSlender}};
  return list;
}

const Family& familyOf(const std::string& name) {
  std::string known;
  for (const Family& family : families()) {
    if (family.name == name) return family;
    known += (known.empty() ? "" : ", ") + family.name;
  }
  throw std::invalid_argument("there is no family '" + name + "', expected one of " + known);
}

Harness makeHarness(const Family& family, std::uint64_t seed, std::uint64_t number) {
  const auto stream = static_cast<std::uint32_t>(&family - families().data());
  Draw draw(seed, stream, number);
  for (int attempt = 0; attempt < 100; ++attempt) {
    Harness harness = family.make(draw);
    if (faultsOf(harness).empty()) return harness;
  }
  throw std::logic_error("family '" + family.name + "' makes no sound harness");
}

}  // namespace cable_variation::hunt
