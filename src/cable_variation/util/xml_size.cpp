#include <cable_variation/util/xml_size.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include <cable_variation/util/input_limits.h>

namespace cable_variation {

void requireXmlSize(std::string_view text, std::size_t most_parts) {
  // an end tag has a < too, and a value may hold either: more are counted than there are
  const auto parts = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return c == '<' || c == '='; }));
  if (parts <= most_parts) return;
  throw std::invalid_argument("it has about " + std::to_string(parts) + " elements and attributes; " +
                              atMost(most_parts, "xml_parts"));
}

}  // namespace cable_variation
