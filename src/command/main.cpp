// The core at the shell, without ROS.
#include <cstdio>
#include <exception>

#include <command/command_line.h>

int main(int count, char** words) {
  try {
    return cable_variation_command::runCommandLine({words + 1, words + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cable_variation: %s\n", error.what());
    return cable_variation_command::kNoSuccess;
  }
}
