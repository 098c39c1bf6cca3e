#pragma once

#include <string>
#include <vector>

namespace cable_variation_command {

// Exit codes.
constexpr int kGood = 0;       ///< the answer is there
constexpr int kNoSuccess = 1;  ///< it is not, or not all of it: its status is not SUCCESS
constexpr int kWrong =
    2;  ///< the usage or the scene is wrong: no verb, option, value, name or file like that

/// All that the program does: answers to the standard output, all else to the standard error.
/// @param words of the command line, without the program
/// @return the exit code
int runCommandLine(const std::vector<std::string>& words);

}  // namespace cable_variation_command
