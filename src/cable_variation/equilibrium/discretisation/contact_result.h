#pragma once  // internal to equilibrium/

#include <string>
#include <vector>

#include <cable_variation/equilibrium/discretisation/contact_system.h>
#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation {

/// Where cables touch, from a system evaluated at `configuration`, whose centrelines are known to `accuracy`
/// [m]: what is no further from a part than that, between two places that press, touches.
std::vector<ContactInterval> describeContacts(const Harness& harness, const Topology& topology,
                                              const ContactSystem& system, const Configuration& configuration,
                                              double accuracy);

/// What makes contact impossible: a clip that holds its cable inside a part that it has contact with, where
/// that counts. Empty: nothing. Throws std::invalid_argument (validate()).
std::string heldInside(const Harness& harness);

/// For a message: which cable passes through which part, and what may be done.
std::string passesThrough(const Harness& harness, std::size_t contact);

/// The smallest of all gaps, stand-offs taken off: by the true tubes about the shapes' centrelines and the
/// true triangles.
struct ExactGap {
  double gap = 0.0;         ///< [m]; infinite: everything is skipped
  std::size_t contact = 0;  ///< index into Harness::contacts
  double arc_length = 0.0;  ///< [m]
};
ExactGap exactGap(const Harness& harness, const ContactSystem& system, const Configuration& configuration,
                  const std::vector<CableShape>& shapes);

}  // namespace cable_variation
