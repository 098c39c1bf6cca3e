#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <cable_variation/util/input_limits.h>

namespace cable_variation {

/// Files whose readers cannot be trusted are read by programs of their own, within limits: both sides of
/// that.

/// How such a program ends.
enum class ImportEnd { done = 0, refused = 2, out_of_memory = 3 };  // beside those of shells

/// What the program NAME (helperProgram()) makes of a file, within the memory and the time that
/// `limits` allow it. It is called with MEMORY [B] SECONDS and `arguments`, `input` being its standard input.
/// Throws std::invalid_argument with what the program says of the file; that it took too long, took too much
/// memory, crashed; or `too_much`, if it writes more than `most_output` bytes.
std::string imported(const std::string& name, const std::vector<std::string>& arguments,
                     std::string_view input, const InputLimits& limits, std::size_t most_output,
                     const std::string& too_much);

/// The main() of such a program: within the bounds that it is called with, with nothing open that its parent
/// has open, and gone with it, it writes what `import` makes of the arguments behind these, or what
/// is wrong with the file: the text of what it throws.
/// @param count of those arguments
/// @param most_written how large a file it may write [B], for libraries that have a cache
int runImport(int argc, char** argv, std::size_t count,
              const std::function<std::string(const std::vector<std::string>&)>& import,
              std::size_t most_written = 0);

}  // namespace cable_variation
