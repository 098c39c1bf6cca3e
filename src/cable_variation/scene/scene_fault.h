#pragma once

#include <string>

namespace cable_variation {

/// What is wrong, or seems to be, in a place of a scene file.
struct SceneFault {
  std::string file;
  int line = 0;         ///< from 1; 0: the file as a whole
  std::string message;  ///< what is there and what was expected
};

/// "FILE:LINE: MESSAGE"
std::string toString(const SceneFault& fault);

}  // namespace cable_variation
