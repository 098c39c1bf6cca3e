#pragma once

#include <functional>
#include <string>
#include <vector>

#include <hunt/family.h>
#include <hunt/tally.h>

namespace cable_variation::hunt {

struct HuntOptions {
  std::size_t count = 25;  ///< per family; divided by Family::share unless in `only`
  std::uint64_t seed = 1;
  std::vector<std::string> only;  ///< families by name; empty: all
  std::size_t first = 0;          ///< number of the first harness of each
  std::size_t starts_every = 1;   ///< simple starts for solved harnesses: of every so many-th, 0: none
  unsigned threads = 0;           ///< 0: as many as the machine has
  JudgeOptions judge;
};

/// One harness that was judged.
struct Hunted {
  std::string family;
  std::uint64_t number = 0;
  Harness harness;
  Judgement judgement;
};

/// Judges harnesses side by side; `each` is told of each in turn, from one thread at a time.
std::vector<Tally> hunt(const HuntOptions& options, const std::function<void(const Hunted&)>& each);

/// The slenderness table: `count` harnesses for each setting and κ.
std::vector<Tally> huntSlender(std::size_t count, const std::vector<double>& kappas,
                               const HuntOptions& options, const std::function<void(const Hunted&)>& each);

}  // namespace cable_variation::hunt
