#include <command/options.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include <cable_variation/util/name_list.h>
#include <cable_variation/util/quantity.h>
#include <cable_variation/util/readable_text.h>

namespace cable_variation_command {

namespace {

constexpr std::size_t kMargin = 2, kValueColumn = 30;  // of the help, in characters

bool isOption(const std::string& word) { return word.size() > 2 && word.compare(0, 2, "--") == 0; }

std::string quoted(const std::string& word) { return "'" + cable_variation::readableText(word) + "'"; }

/// "--NAME" of a word that may have its value behind a '='.
std::string nameIn(const std::string& word) {
  std::string name = word.substr(2, word.find('=') - 2);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::vector<std::string> partedByCommas(const std::vector<std::string>& words) {
  std::vector<std::string> parts;
  for (const std::string& word : words) {
    std::size_t start = 0;
    for (std::size_t comma; (comma = word.find(',', start)) != std::string::npos; start = comma + 1)
      parts.push_back(word.substr(start, comma - start));
    parts.push_back(word.substr(start));
  }
  parts.erase(std::remove(parts.begin(), parts.end(), ""), parts.end());
  return parts;
}

double numberIn(const std::string& text, const std::string& si_unit) {
  if (si_unit == "1" && !text.empty() && text.back() == '%') {
    constexpr double kHundred = 100.0;
    return cable_variation::parseQuantity(text.substr(0, text.size() - 1),
                                          cable_variation::quantity::number) /
           kHundred;
  }
  for (const cable_variation::Quantity* each :
       {&cable_variation::quantity::length, &cable_variation::quantity::angle}) {
    if (si_unit == each->unit) return cable_variation::parseQuantity(text, *each);
  }
  if (si_unit == "s") {
    static const cable_variation::Quantity kTime{"a time", "s", "0.2", {0, 0, 1, 0}, "s, ms"};
    return cable_variation::parseQuantity(text, kTime);
  }
  return cable_variation::parseQuantity(text, cable_variation::quantity::number);
}

template <typename Count>
Count wholeNumberIn(const std::string& option, const std::string& text, Count least, const char* otherwise) {
  const char* const end = text.data() + text.size();
  Count read = 0;
  const std::from_chars_result result = std::from_chars(text.data(), end, read);
  if (result.ec == std::errc() && result.ptr == end && read >= least) return read;
  throw UsageError("--" + option + ": is " + quoted(text) + ", expected a whole number, " +
                   std::to_string(least) + " to " + std::to_string(std::numeric_limits<Count>::max()) +
                   otherwise);
}

// None is what an option that is left out stands for: asked for by its number it would be another.
template <typename Count>
Count countIn(const std::string& option, const std::string& text) {
  return wholeNumberIn<Count>(option, text, 1, ", or the option left out");
}

}  // namespace

void Options::add(Option option) {
  for (const Option& each : options_) {
    if (each.name == option.name) throw std::logic_error("two options --" + option.name);
  }
  options_.push_back(std::move(option));
}

void Options::word(const char* name, std::string& to, const std::string& help) {
  words_.push_back({name, help, &to});
}

void Options::words(const char* name, std::vector<std::string>& to, const std::string& help) {
  more_ = {name, help, nullptr};
  all_ = &to;
}

void Options::shortName(char letter, const char* name) {
  find(name);
  letters_[letter] = name;
}

/// A word as it is, but the short name of an option as the long one.
std::string Options::longForm(const std::string& word) const {
  const auto letter = word.size() == 2 && word.front() == '-' ? letters_.find(word.back()) : letters_.end();
  return letter == letters_.end() ? word : "--" + letter->second;
}

void Options::flag(const char* name, bool& to, const std::string& help) {
  add({name, "", help, Takes::nothing, [&to](const auto& /*none*/) { to = true; }});
}

void Options::text(const char* name, const char* value, std::string& to, const std::string& help) {
  add({name, value, help, Takes::one, [&to](const auto& values) { to = values.front(); }});
}

void Options::texts(const char* name, const char* value, std::vector<std::string>& to,
                    const std::string& help) {
  const std::string option = name;
  add({name, std::string(value) + " ...", help, Takes::several, [&to, option](const auto& values) {
         to = partedByCommas(values);
         if (to.empty()) throw UsageError("--" + option + ": is empty, expected one value at least");
       }});
}

void Options::number(const char* name, const char* value, const char* si_unit, double& to,
                     const std::string& help) {
  const std::string option = name, unit = si_unit;
  add({name, value, help, Takes::one, [&to, option, unit](const auto& values) {
         try {
           to = numberIn(values.front(), unit);
         } catch (const std::invalid_argument& error) {
           throw UsageError("--" + option + ": " + error.what());
         }
       }});
}

void Options::count(const char* name, const char* value, std::uint64_t& to, const std::string& help) {
  const std::string option = name;
  add({name, value, help, Takes::one,
       [&to, option](const auto& values) { to = countIn<std::uint64_t>(option, values.front()); }});
}

void Options::count(const char* name, const char* value, std::uint32_t& to, const std::string& help) {
  const std::string option = name;
  add({name, value, help, Takes::one,
       [&to, option](const auto& values) { to = countIn<std::uint32_t>(option, values.front()); }});
}

void Options::index(const char* name, const char* value, std::uint64_t& to, const std::string& help) {
  const std::string option = name;
  add({name, value, help, Takes::one, [&to, option](const auto& values) {
         to = wholeNumberIn<std::uint64_t>(option, values.front(), 0, "");
       }});
}

Options::Option& Options::find(const std::string& name) {
  std::vector<std::string> known;
  for (Option& each : options_) {
    if (each.name == name) return each;
    known.push_back("--" + each.name);
  }
  throw UsageError("unknown option " + quoted("--" + name) + cable_variation::didYouMean("--" + name, known));
}

bool Options::given(const std::string& name) const {
  return std::any_of(options_.begin(), options_.end(),
                     [&](const Option& each) { return each.name == name && each.given; });
}

void Options::read(const std::vector<std::string>& words) {
  std::size_t taken = 0;
  for (std::size_t i = 0; i < words.size();) {
    const std::string word = longForm(words[i++]);
    if (!isOption(word)) {
      if (taken == words_.size() && all_ != nullptr) {
        all_->push_back(word);
        continue;
      }
      if (taken == words_.size()) {
        throw UsageError("unexpected " + quoted(word) + ", expected " +
                         (words_.empty() ? "options only" : words_.back().name + " once, and options"));
      }
      *words_[taken++].to = word;
      continue;
    }
    Option& option = find(nameIn(word));
    if (option.given) throw UsageError("--" + option.name + ": is given twice");
    option.given = true;
    std::vector<std::string> values;
    const std::size_t equals = word.find('=');
    if (equals != std::string::npos) {
      if (option.takes == Takes::nothing) throw UsageError("--" + option.name + ": takes no value");
      values.push_back(word.substr(equals + 1));
    }
    const std::size_t most = option.takes == Takes::nothing ? 0
                             : option.takes == Takes::one   ? 1
                                                            : words.size();
    while (equals == std::string::npos && i < words.size() && values.size() < most &&
           !isOption(longForm(words[i])))
      values.push_back(words[i++]);
    if (option.takes != Takes::nothing && values.empty())
      throw UsageError("--" + option.name + ": has no value, expected " + option.value);
    option.store(values);
  }
  if (taken < words_.size())
    throw UsageError(words_[taken].name + " is missing: expected " + words_[taken].help);
  if (all_ != nullptr && all_->empty()) throw UsageError(more_.name + " are missing: expected " + more_.help);
}

std::string Options::usage() const {
  std::string line;
  for (const Word& each : words_) line += each.name + " ";
  if (all_ != nullptr) line += more_.name + " ... ";
  return line + "[OPTIONS]";
}

std::string Options::help() const {
  std::string lines;
  const auto add = [&](const std::string& left, const std::string& right) {
    const std::string start = std::string(kMargin, ' ') + left;
    lines += start + std::string(start.size() < kValueColumn ? kValueColumn - start.size() : 2, ' ') + right +
             "\n";
  };
  for (const Word& each : words_) add(each.name, each.help);
  if (all_ != nullptr) add(more_.name + " ...", more_.help);
  for (const Option& each : options_)
    add("--" + each.name + (each.value.empty() ? "" : " " + each.value), each.help);
  return lines;
}

}  // namespace cable_variation_command
