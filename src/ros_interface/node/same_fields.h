#pragma once

#include <cstdint>
#include <vector>

#include <ros/message_traits.h>
#include <ros/serialization.h>

namespace cable_variation_ros {

/// A message as another type with the same fields, such as the goal of an action and the request of the
/// service that does the same. That they are the same, the compiler sees by the checksums of their
/// definitions.
template <typename To, typename From>
To sameFields(const From& from) {
  using ToSum = ros::message_traits::MD5Sum<To>;
  using FromSum = ros::message_traits::MD5Sum<From>;
  static_assert(
      ToSum::static_value1 == FromSum::static_value1 && ToSum::static_value2 == FromSum::static_value2,
      "the fields of the two messages differ");
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(from));
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, from);
  To to;
  ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(in, to);
  return to;
}

}  // namespace cable_variation_ros
