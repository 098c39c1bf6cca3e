#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cable_variation {

/// What became of a program that was run as a process of its own.
struct ChildRun {
  enum class End { exited, killed_by_signal, took_too_long, wrote_too_much };
  End end = End::exited;
  int code = 0;        ///< its exit code, or the signal's number
  std::string output;  ///< what it wrote to its standard output
};

/// Runs a program with `input` as its standard input, a file that nobody else sees, and waits for it. It
/// inherits no standard error. After `seconds`, or when it has written more than `most_output` bytes, it is
/// killed. Bounds on its memory and CPU time are the program's own to set, see limitThisProcess().
/// Throws FileError with what the system says if it cannot be started.
ChildRun runChild(const std::string& program, const std::vector<std::string>& arguments,
                  std::string_view input, double seconds, std::size_t most_output);

/// "Segmentation fault" and the like.
std::string signalName(int signal);

}  // namespace cable_variation
