#include <cable_variation/util/import_program.h>

#include <csignal>
#include <stdexcept>

#include <cable_variation/util/child_process.h>
#include <cable_variation/util/helper_program.h>
#include <cable_variation/util/readable_text.h>

namespace cable_variation {

std::string imported(const std::string& name, const std::vector<std::string>& arguments,
                     std::string_view input, const InputLimits& limits, std::size_t most_output,
                     const std::string& too_much) {
  const std::string seconds = std::to_string(limits.import_seconds);
  std::vector<std::string> words{std::to_string(limits.import_memory), seconds};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const ChildRun run =
      runChild(helperProgram(name), words, input, static_cast<double>(limits.import_seconds), most_output);
  const auto took_too_long = [&] {
    return std::invalid_argument("reading it took longer than the " + seconds +
                                 " s of the limit import_seconds; it was given up");
  };
  switch (run.end) {
    case ChildRun::End::took_too_long:
      throw took_too_long();
    case ChildRun::End::wrote_too_much:
      throw std::invalid_argument(too_much);
    case ChildRun::End::killed_by_signal:
      if (run.code == SIGXCPU || run.code == SIGKILL) throw took_too_long();
      throw std::invalid_argument("its importer crashed (" + signalName(run.code) +
                                  "); expected a file that can be read");
    case ChildRun::End::exited:
      break;
  }
  if (run.code == static_cast<int>(ImportEnd::refused)) throw std::invalid_argument(readableText(run.output));
  if (run.code == static_cast<int>(ImportEnd::out_of_memory)) {
    throw std::invalid_argument("reading it took more than the " + std::to_string(limits.import_memory) +
                                " bytes of the limit import_memory; it was given up");
  }
  if (run.code != static_cast<int>(ImportEnd::done)) {
    throw std::invalid_argument("its importer ended with code " + std::to_string(run.code));
  }
  return run.output;
}

}  // namespace cable_variation
