#pragma once  // internal to envelope/

#include <sstream>

#include <cable_variation/envelope/envelope.h>

namespace cable_variation {

/// Adds a warning made of texts and numbers, these to three digits.
template <class... Parts>
void warn(Envelope& envelope, const Parts&... parts) {
  std::ostringstream text;
  text.precision(3);
  (text << ... << parts);
  envelope.warnings.push_back(text.str());
}

}  // namespace cable_variation
