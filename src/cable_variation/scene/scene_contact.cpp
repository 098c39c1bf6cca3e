#include <cable_variation/scene/scene_contact.h>

#include <map>
#include <memory>
#include <stdexcept>

#include <cable_variation/contact/part_surface.h>
#include <cable_variation/scene/merged_mesh.h>
#include <cable_variation/scene/moving_components.h>

namespace cable_variation {

void makeContacts(Scene& scene) {
  std::map<std::size_t, std::shared_ptr<const ContactSurface>> surfaces;
  scene.harness.contacts.clear();
  scene.contact_components.clear();
  scene.contact_parts.clear();
  for (const SceneContact& contact : scene.contacts) {
    for (const std::size_t component : contact.components) {
      bool any = false;
      for (const std::size_t body : bodiesOf(scene, component)) {
        const TriangleMesh mesh = mergedMesh(scene.components[body]);
        if (mesh.triangles.empty()) continue;
        any = true;
        std::shared_ptr<const ContactSurface>& surface = surfaces[body];
        if (!surface) {
          const auto part = std::make_shared<const DistancePart>(mesh);
          scene.contact_parts[body] = part;
          surface = makePartSurface(part);
        }
        for (const std::size_t cable : contact.cables) {
          PartContact made;
          made.cable = cable;
          made.part = scene.components[body].name;
          made.surface = surface;
          made.stand_off = contact.stand_off;
          made.skip_near_clips = contact.skip_near_clips;
          scene.harness.contacts.push_back(made);
          scene.contact_components.push_back(body);
        }
      }
      if (any) continue;
      throw std::invalid_argument("component '" + scene.components[component].name +
                                  "' has no triangles; contact expects a part that has");
    }
  }
}

void placeContacts(const Scene& scene, const std::vector<ComponentFrame>& frames, Harness& harness) {
  for (std::size_t i = 0; i < harness.contacts.size(); ++i) {
    PartContact& contact = harness.contacts[i];
    const std::size_t component = scene.contact_components[i];
    contact.pose = frames[component].pose;
    contact.own_clips.clear();
    for (std::size_t clip = 0; clip < scene.clip_mounts.size(); ++clip) {
      if (harness.clips[clip].cable == contact.cable && ridesOn(scene, clip, scene.components[component]))
        contact.own_clips.push_back(clip);
    }
  }
}

}  // namespace cable_variation
