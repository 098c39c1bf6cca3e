#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cable_variation {

/// Words of a text, one after the other, and the line each is in.
class TextTokens {
 public:
  explicit TextTokens(std::string_view text, std::size_t first_line = 1) : text_(text), line_(first_line) {}

  /// The next word in this line or further down; none: the text ends.
  std::optional<std::string_view> next();
  /// The next word in this line; none: the line ends.
  std::optional<std::string_view> nextInLine();
  void skipLine();
  bool atEnd();
  /// Whether nothing but the text's end stands behind the word given last.
  bool lastIsCut() const { return at_ == text_.size(); }
  std::size_t line() const { return line_; }

 private:
  void skipBlanks(bool lines);

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_;
};

/// The number that all of a word is; none: it is no number. Infinities and nan are none.
std::optional<double> numberIn(std::string_view word);

std::string lowerCase(std::string_view text);

/// The word in quotes, shortened, without what a terminal would take for commands.
std::string quoted(std::string_view word);

}  // namespace cable_variation
