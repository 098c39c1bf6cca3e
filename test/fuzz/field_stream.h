#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include "fuzz_bytes.h"

namespace cable_variation {

/// A stream of roscpp's that makes the fields of a message of bytes, whatever they are: numbers of every
/// kind, texts of up to 40 bytes or out of a list, lists of up to five.
class FieldStream {
 public:
  /// @param words some that mean something to who gets the message; must outlive it
  FieldStream(FuzzBytes& bytes, const std::vector<std::string>& words) : bytes_(bytes), words_(words) {}

  template <typename Message>
  void next(Message& message) {
    if constexpr (std::is_floating_point_v<Message>) {
      message = static_cast<Message>(number());
    } else if constexpr (std::is_integral_v<Message>) {
      std::uint64_t value = 0;
      const unsigned size = bytes_.below(static_cast<unsigned>(sizeof(Message)) + 1);
      for (unsigned i = 0; i < size; ++i) value = 256 * value + bytes_.byte();
      message = static_cast<Message>(value);
    } else {
      ros::serialization::Serializer<Message>::allInOne(*this, message);
    }
  }
  void next(std::string& text) {
    text.clear();
    if (!bytes_.chance(4)) {
      const unsigned word = bytes_.below(static_cast<unsigned>(words_.size()) + 1);
      if (word > 0) text = words_[word - 1];
      return;
    }
    for (unsigned left = bytes_.below(41); left > 0; --left) text += static_cast<char>(bytes_.byte());
  }
  void next(ros::Time& time) {
    next(time.sec);
    next(time.nsec);
  }
  void next(ros::Duration& duration) {
    next(duration.sec);
    next(duration.nsec);
  }
  template <typename Item, typename Allocator>
  void next(std::vector<Item, Allocator>& list) {
    list.clear();
    for (unsigned left = bytes_.below(6); left > 0; --left) {
      Item item = Item();
      next(item);
      list.push_back(item);
    }
  }
  template <typename Item, std::size_t size>
  void next(boost::array<Item, size>& list) {
    for (Item& item : list) next(item);
  }

 private:
  double number() {
    switch (bytes_.below(4)) {
      case 0:
        return 0.0;
      case 1:
        return bytes_.number(-1.0, 1.0);
      case 2:
        return bytes_.number(0.0, 1e-2);
      default:
        return bytes_.number(-1e6, 1e6);
    }
  }

  FuzzBytes& bytes_;
  const std::vector<std::string>& words_;
};

}  // namespace cable_variation
