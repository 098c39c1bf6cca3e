#pragma once

#include <vector>

#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// What Harness::contacts and Scene::contact_components are by Scene::contacts: makes the surfaces, which is
/// costly. Throws std::invalid_argument that names a component without triangles.
void makeContacts(Scene& scene);

/// Puts the contacts of `harness`, one of the scene's, where the components are.
void placeContacts(const Scene& scene, const std::vector<ComponentFrame>& frames, Harness& harness);

}  // namespace cable_variation
