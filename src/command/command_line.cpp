#include <command/command_line.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <cable_variation/analysis/background_run.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/name_list.h>
#include <cable_variation/util/readable_text.h>
#include <cable_variation/util/version.h>
#include <command/interrupt.h>
#include <command/scene_json.h>
#include <command/status_line.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::AnswerStatus;
using cable_variation::BackgroundRun;
using cable_variation::RunControl;
using cable_variation::SceneError;
using cable_variation::StatusCode;

namespace {

constexpr std::chrono::milliseconds kLook(50);
// A cancelled run without an answer has this long to tidy up.
constexpr std::chrono::milliseconds kTidyUp(1000);

int exitCode(StatusCode code) {
  switch (code) {
    case StatusCode::success:
      return kGood;
    case StatusCode::invalid_argument:
    case StatusCode::not_found:
      return kWrong;
    default:
      return kNoSuccess;
  }
}

/// Whether all of it went there: a full disk is told, not passed over.
bool print(const std::string& text) {
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
}

void tell(const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); }

std::string overview() {
  std::string text = "cable_variation VERB [OPTIONS]: virtual verification of cables and hoses\n\n";
  for (const VerbRow& row : verbs()) {
    const std::string name = row.name;
    text += "  " + name + std::string(name.size() < 12 ? 12 - name.size() : 1, ' ') + row.summary + "\n";
  }
  return text +
         "\ncable_variation VERB --help tells the options of a verb. Exit code 0: good; 1: the answer is not "
         "SUCCESS;\n2: wrong usage or scene.\n";
}

std::string helpOf(const VerbRow& row, const Options& options) {
  return std::string("cable_variation ") + row.name + " " + options.usage() + "\n" + row.summary + "\n\n" +
         row.about + "\n\n" + options.help();
}

const VerbRow& rowOf(const std::string& name) {
  std::vector<std::string> known;
  for (const VerbRow& row : verbs()) {
    if (name == row.name) return row;
    known.emplace_back(row.name);
  }
  throw UsageError("unknown verb '" + cable_variation::readableText(name) + "'" +
                   cable_variation::didYouMean(name, known) + "; cable_variation --help lists them");
}

/// What the work threw, as an answer.
Answer failed(const std::exception& error) {
  Answer answer;
  answer.status = cable_variation::answerStatus(error);
  return answer;
}

Answer cancelled() {
  Answer answer;
  answer.status = {StatusCode::cancelled, "cancelled"};
  return answer;
}

/// @param who says what went wrong, in front of it; empty: a scene's faults, which say where they are
int report(const std::string& who, const Answer& answer, bool json) {
  if (answer.quiet) return kGood;
  if (!json) {
    for (const std::string& warning : answer.warnings) tell("warning: " + warning);
  }
  std::string text = answer.text;
  if (json) {
    Json all = Json::object();
    all.set("status", Json::object()
                          .set("code", static_cast<int>(answer.status.code))
                          .set("message", answer.status.message));
    all.append(answer.json);
    text = all.text();
  }
  const bool printed = print(text);
  if (!answer.status.message.empty()) tell(who + answer.status.message);
  if (printed) return exitCode(answer.status.code);
  tell(who + "the answer cannot be written to the standard output");
  return kNoSuccess;
}

/// A run that does not notice that it is cancelled is left where it is: it has written nothing.
[[noreturn]] void leave(const std::string& who, bool json) { std::_Exit(report(who, cancelled(), json)); }

int runVerb(const VerbRow& row, Verb& verb, bool json) {
  countInterrupts();
  std::string who = std::string("cable_variation ") + row.name + ": ";
  Answer answer;
  {
    StatusLine line;
    BackgroundRun run([&](RunControl& control) { answer = verb.run(control); });
    bool asked = false;
    while (!run.wait(kLook)) {
      line.show(run.control().progress());
      if (asked || !interrupted()) continue;
      asked = true;
      line.clear();
      if (!run.control().cancel() || verb.keepsWhatWasDone() || run.wait(kTidyUp)) continue;
      leave(who, json);
    }
    line.clear();
    try {
      run.finish();
    } catch (const SceneError& error) {
      answer = failed(error);
      answer.json.set("faults", faultsJson(error.faults()));
      who.clear();
    } catch (const std::exception& error) {
      answer = failed(error);
    }
  }
  return report(who, answer, json);
}

}  // namespace

int runCommandLine(const std::vector<std::string>& words) {
  try {
    if (words.empty()) throw UsageError("no verb; cable_variation --help lists them");
    if (words.front() == "--help" || words.front() == "-h") return print(overview()) ? kGood : kNoSuccess;
    if (words.front() == "--version")
      return print(std::string("cable_variation ") + cable_variation::packageVersion() + "\n") ? kGood
                                                                                               : kNoSuccess;
    const VerbRow& row = rowOf(words.front());
    const std::unique_ptr<Verb> verb = row.make();
    Options options;
    bool json = false, help = false;
    verb->declare(options);
    options.flag("json", json, "the answer for a program: JSON, SI units");
    options.flag("help", help, "this text");
    const std::vector<std::string> rest(words.begin() + 1, words.end());
    for (const std::string& word : rest) {
      if (word == "--help" || word == "-h") return print(helpOf(row, options)) ? kGood : kNoSuccess;
    }
    options.read(rest);
    return runVerb(row, *verb, json);
  } catch (const UsageError& error) {
    tell(std::string("cable_variation") +
         (words.empty() ? "" : " " + cable_variation::readableText(words.front())) + ": " + error.what());
    return kWrong;
  }
}

}  // namespace cable_variation_command
