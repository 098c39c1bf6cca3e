#include <ros_interface/conversion/event_conversion.h>

#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::CableEvent;
using cable_variation::ShapeEvent;

namespace {

std::uint8_t codeOf(ShapeEvent::Kind kind) {
  switch (kind) {
    case ShapeEvent::Kind::snapped:
      return CableEvent::SNAPPED;
    case ShapeEvent::Kind::equilibrium_lost:
      return CableEvent::EQUILIBRIUM_LOST;
    case ShapeEvent::Kind::overstretched:
      return CableEvent::OVERSTRETCHED;
    case ShapeEvent::Kind::equilibrium_back:
      return CableEvent::EQUILIBRIUM_BACK;
    case ShapeEvent::Kind::limit_broken:
      return CableEvent::LIMIT_BROKEN;
    case ShapeEvent::Kind::limit_kept:
      return CableEvent::LIMIT_KEPT;
    case ShapeEvent::Kind::clip_closed:
      return CableEvent::CLIP_CLOSED;
    case ShapeEvent::Kind::clip_opened:
      return CableEvent::CLIP_OPENED;
    case ShapeEvent::Kind::clip_refused:
      break;
  }
  return CableEvent::CLIP_REFUSED;
}

}  // namespace

CableEvent toMessage(const ShapeEvent& event, const ros::Time& stamp) {
  CableEvent message;
  message.header.stamp = stamp;
  message.header.frame_id = kWorldFrame;
  message.kind = codeOf(event.kind);
  message.cable = event.cable;
  message.arc_length = event.arc_length;
  message.measure = event.measure;
  message.clip = event.clip;
  message.text = event.text;
  message.from_value = event.from_value;
  message.to_value = event.to_value;
  message.distance = event.distance;
  return message;
}

}  // namespace cable_variation_ros
