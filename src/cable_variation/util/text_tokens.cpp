#include <cable_variation/util/text_tokens.h>

#include <cmath>
#include <system_error>

#include <cable_variation/util/number_text.h>

namespace cable_variation {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

}  // namespace

void TextTokens::skipBlanks(bool lines) {
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '\n') {
      if (!lines) return;
      ++line_;
    } else if (!isBlank(text_[at_])) {
      return;
    }
  }
}

std::optional<std::string_view> TextTokens::next() {
  skipBlanks(true);
  return nextInLine();
}

std::optional<std::string_view> TextTokens::nextInLine() {
  skipBlanks(false);
  const std::size_t start = at_;
  while (at_ < text_.size() && text_[at_] != '\n' && !isBlank(text_[at_])) ++at_;
  if (at_ == start) return std::nullopt;
  return text_.substr(start, at_ - start);
}

void TextTokens::skipLine() {
  while (at_ < text_.size() && text_[at_] != '\n') ++at_;
}

bool TextTokens::atEnd() {
  skipBlanks(true);
  return at_ == text_.size();
}

std::optional<double> numberIn(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = readNumber(word, value);
  if (end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // too small to be told from 0, or too large: the exponent's sign tells
    return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos
               ? std::optional<double>(0.0)
               : std::nullopt;
  }
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string quoted(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + text + (word.size() > kLongest ? "...'" : "'");
}

}  // namespace cable_variation
