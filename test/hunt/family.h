#pragma once

#include <string>
#include <vector>

#include <cable_variation/harness/harness.h>
#include <hunt/draw.h>

namespace cable_variation::hunt {

/// A kind of harness that people really build, or that solvers really fail at.
struct Family {
  std::string name;
  Harness (*make)(Draw&);
  std::size_t share = 1;  ///< one is tried for so many of the other families'
};

/// All twenty, in the order of the table in doc/hunt.md.
const std::vector<Family>& families();

/// The family of that name. Throws std::invalid_argument that lists the names there are.
const Family& familyOf(const std::string& name);

/// The harness of that seed, family and number, always the same and always sound (faultsOf() is empty).
Harness makeHarness(const Family& family, std::uint64_t seed, std::uint64_t number);

// One cable, held at its ends or nearly so.
Harness makeTwoEnds(Draw& draw);
Harness makeAnyOrientation(Draw& draw);
Harness makeFlippedEnds(Draw& draw);
Harness makeTwistHint(Draw& draw);
Harness makePitchfork(Draw& draw);
Harness makeLongSlack(Draw& draw);
Harness makePreformed(Draw& draw);

// One cable with clips along it, or with a free end.
Harness makeSeveralClips(Draw& draw);
Harness makeSlidingNearEnd(Draw& draw);
Harness makeTwoSlides(Draw& draw);
Harness makeFreeEnds(Draw& draw);
Harness makeHeavyTip(Draw& draw);

// Cables joined.
Harness makeChain(Draw& draw);
Harness makeBranches(Draw& draw);
Harness makeLoop(Draw& draw);
Harness makeStiffSoft(Draw& draw);
Harness makeBig(Draw& draw);

// Where one stiffness or weight is far above another.
Harness makeThinWire(Draw& draw);
Harness makeLongSoft(Draw& draw);
Harness makeSlender(Draw& draw);

}  // namespace cable_variation::hunt
