#pragma once

#include <memory>
#include <string>
#include <vector>

#include <cable_variation/analysis/answer_status.h>
#include <cable_variation/analysis/run_control.h>
#include <command/json.h>
#include <command/options.h>

namespace cable_variation_command {

/// What a verb has to say once it has ended.
struct Answer {
  cable_variation::AnswerStatus status;
  std::string text;                   ///< for a person: lines, as they go to the standard output
  Json json = Json::object();         ///< for a program: the fields beside the status
  std::vector<std::string> warnings;  ///< for a person, to the standard error; `json` has them by itself
  bool quiet = false;                 ///< another process answers for this one: nothing is told, exit code 0
};

/// What `cable_variation` does at a word such as "solve". Its options' values are in the object.
class Verb {
 public:
  virtual ~Verb() = default;

  virtual void declare(Options& options) = 0;
  /// On a thread of its own. Throws what goes wrong: the answer is then that alone (answerStatus()).
  /// @param control told how far it is; a verb calls RunControl::complete() before it writes a file, after
  /// which it is not cancelled any more
  virtual Answer run(cable_variation::RunControl& control) = 0;
  /// Whether a run that is cancelled has an answer too, of what was done until then. One that has not is left
  /// where it is if it does not notice at once.
  virtual bool keepsWhatWasDone() const { return false; }
};

/// A row of the table of verbs, verbs().
struct VerbRow {
  const char* name;
  const char* summary;  ///< one line, for the list of verbs
  const char* about;    ///< some lines more, for --help of the verb
  std::unique_ptr<Verb> (*make)();
};

/// All that there are, in the order that they are listed in.
const std::vector<VerbRow>& verbs();

// One file each.
std::unique_ptr<Verb> makeCheck();
std::unique_ptr<Verb> makeEnvelope();
std::unique_ptr<Verb> makeExport();
std::unique_ptr<Verb> makeIdentify();
std::unique_ptr<Verb> makeImport();
std::unique_ptr<Verb> makeMerge();
std::unique_ptr<Verb> makeReport();
std::unique_ptr<Verb> makeSimulate();
std::unique_ptr<Verb> makeSolve();
std::unique_ptr<Verb> makeStability();

}  // namespace cable_variation_command
