#pragma once

#include <vector>

#include <cable_variation/CableContact.h>
#include <cable_variation/ContactInfo.h>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation_ros {

/// What cables of `harness` touch, of a converged equilibrium; empty otherwise.
std::vector<cable_variation::CableContact> toContacts(const cable_variation::Equilibrium& equilibrium,
                                                      const cable_variation::Harness& harness);

/// Which cable may touch which component.
std::vector<cable_variation::ContactInfo> contactInfos(const cable_variation::Harness& harness);

}  // namespace cable_variation_ros
