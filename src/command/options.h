#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace cable_variation_command {

/// Wrong usage of the command line; what() names the option or word and what was expected.
class UsageError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The options that a verb takes, bound to where their values go, which must outlive this. Options are named
/// as the fields of the services' requests; a dash in a name is read as an underscore.
class Options {
 public:
  /// The word before or after all options. @param help of one line, as those below
  void word(const char* name, std::string& to, const std::string& help);

  /// One such word or more, after those of word().
  void words(const char* name, std::vector<std::string>& to, const std::string& help);

  /// A letter that "-LETTER" stands for an option by, which is declared.
  void shortName(char letter, const char* name);

  void flag(const char* name, bool& to, const std::string& help);
  void text(const char* name, const char* value, std::string& to, const std::string& help);
  /// One word or more; commas part them as well.
  void texts(const char* name, const char* value, std::vector<std::string>& to, const std::string& help);
  /// SI; or with a unit of the dimension of `si_unit`, "1": a number or percentage.
  void number(const char* name, const char* value, const char* si_unit, double& to, const std::string& help);
  /// A whole number from 1 on.
  void count(const char* name, const char* value, std::uint32_t& to, const std::string& help);
  void count(const char* name, const char* value, std::uint64_t& to, const std::string& help);
  /// A whole number from 0 on.
  void index(const char* name, const char* value, std::uint64_t& to, const std::string& help);

  /// Reads the words after the verb. Throws UsageError: an option that is not known, with the nearest one
  /// that is, or given twice; a value that is missing or wrong; a word too many or missing.
  void read(const std::vector<std::string>& words);

  bool given(const std::string& name) const;  ///< whether an option was, once read

  /// A line for each option: its name, its value and what it means.
  std::string help() const;
  std::string usage() const;  ///< "SCENE [OPTIONS]"

 private:
  enum class Takes { nothing, one, several };
  struct Option {
    std::string name, value, help;
    Takes takes = Takes::one;
    std::function<void(const std::vector<std::string>&)> store;
    bool given = false;
  };
  struct Word {
    std::string name, help;
    std::string* to;
  };

  void add(Option option);
  Option& find(const std::string& name);

  std::string longForm(const std::string& word) const;

  std::vector<Option> options_;
  std::map<char, std::string> letters_;
  std::vector<Word> words_;
  Word more_{};                              // of words()
  std::vector<std::string>* all_ = nullptr;  // where they go; nullptr: there are none
};

}  // namespace cable_variation_command
