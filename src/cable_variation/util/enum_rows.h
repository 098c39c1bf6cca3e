#pragma once

#include <cstddef>
#include <string_view>

namespace cable_variation {

/// Whether `value` is an enumerator and not only a number cast to the enum. GCC and Clang write a template's
/// argument with the enumerator's name, or as the cast "(Enum)14".
template <typename Enum, Enum value>
constexpr bool isEnumerator() {
  const std::string_view text = __PRETTY_FUNCTION__;
  return text[text.find("value = ") + std::string_view("value = ").size()] != '(';
}

/// How many enumerators an enum has that counts from 0 without gaps.
template <typename Enum, std::size_t from = 0>
constexpr std::size_t enumeratorCount() {
  if constexpr (isEnumerator<Enum, static_cast<Enum>(from)>()) {
    return enumeratorCount<Enum, from + 1>();
  } else {
    return from;
  }
}

/// Whether a table has one row for each enumerator, in their order: asserted where such a table stands, so
/// that an enumerator without a row does not compile. @param key the rows' member that is the enumerator
template <typename Rows, typename Row, typename Enum>
constexpr bool hasRowOfEach(const Rows& rows, Enum Row::*key) {
  if (rows.size() != enumeratorCount<Enum>()) return false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].*key != static_cast<Enum>(i)) return false;
  }
  return true;
}

}  // namespace cable_variation
