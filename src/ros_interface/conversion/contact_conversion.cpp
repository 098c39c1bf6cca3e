#include <ros_interface/conversion/contact_conversion.h>

#include <ros_interface/conversion/message_conversion.h>

namespace cable_variation_ros {

using cable_variation::CableContact;
using cable_variation::ContactInfo;

std::vector<CableContact> toContacts(const cable_variation::Equilibrium& equilibrium,
                                     const cable_variation::Harness& harness) {
  std::vector<CableContact> messages;
  if (!equilibrium.converged()) return messages;
  for (const cable_variation::ContactInterval& interval : equilibrium.contacts) {
    CableContact message;
    message.cable = harness.cables[interval.cable].name;
    message.component = interval.part;
    message.start = interval.start;
    message.end = interval.end;
    message.force = toVector(interval.force);
    message.moment = toVector(interval.moment);
    message.total = interval.total;
    for (const cable_variation::ContactForce& place : interval.places) {
      message.arc_length.push_back(place.arc_length);
      message.on_component.push_back(toPoint(place.on_part));
      message.place_force.push_back(toVector(place.force * place.direction));
    }
    messages.push_back(message);
  }
  return messages;
}

std::vector<ContactInfo> contactInfos(const cable_variation::Harness& harness) {
  std::vector<ContactInfo> infos;
  for (const cable_variation::PartContact& contact : harness.contacts) {
    ContactInfo info;
    info.cable = harness.cables[contact.cable].name;
    info.component = contact.part;
    info.stand_off = contact.stand_off;
    info.skip_near_clips = contact.skip_near_clips;
    infos.push_back(info);
  }
  return infos;
}

}  // namespace cable_variation_ros
