#pragma once

#include <ros/time.h>

#include <cable_variation/CableEvent.h>

#include <cable_variation/tracking/shape_event.h>

namespace cable_variation_ros {

/// @param stamp of what the shape was computed from
cable_variation::CableEvent toMessage(const cable_variation::ShapeEvent& event, const ros::Time& stamp);

}  // namespace cable_variation_ros
