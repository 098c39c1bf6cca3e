// What goes on only with an equilibrium says why there is none.
#include <cable_variation/equilibrium/require_converged.h>

#include <gtest/gtest.h>

#include <cable_variation/util/error.h>

namespace cable_variation {
namespace {

struct Told {
  ErrorKind kind;
  std::string message;
};

Told told(EquilibriumStatus status, const std::string& what) {
  Equilibrium equilibrium;
  equilibrium.status = status;
  equilibrium.message = "cable 'strand' is too short";
  try {
    requireConverged(equilibrium, what);
  } catch (const std::exception& error) {
    return {kindOf(error), error.what()};
  }
  ADD_FAILURE() << toString(status) << " went on";
  return {};
}

TEST(require_converged, throws_the_kind_of_each_status) {
  EXPECT_EQ(told(EquilibriumStatus::not_converged, "").kind, ErrorKind::not_converged);
  EXPECT_EQ(told(EquilibriumStatus::unstable, "").kind, ErrorKind::unstable);
  EXPECT_EQ(told(EquilibriumStatus::impossible, "").kind, ErrorKind::impossible);
  Equilibrium found;
  found.status = EquilibriumStatus::converged;
  EXPECT_NO_THROW(requireConverged(found));
}

TEST(require_converged, says_what_cannot_go_on_and_why) {
  EXPECT_EQ(told(EquilibriumStatus::impossible, "the design has no equilibrium").message,
            "the design has no equilibrium: cable 'strand' is too short");
  EXPECT_EQ(told(EquilibriumStatus::unstable, "").message,
            std::string(toString(EquilibriumStatus::unstable)) + ": cable 'strand' is too short");
}

}  // namespace
}  // namespace cable_variation
