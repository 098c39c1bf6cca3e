#pragma once

#include <cstdint>
#include <exception>
#include <string>

namespace cable_variation {

/// How a request ended, for whoever asked: the codes of the message Status.
enum class StatusCode : std::uint8_t {
  success = 0,
  invalid_argument = 1,  ///< a value out of its bounds, a scene file with faults
  not_found = 2,         ///< no design variable, cable, clip, motion or file of that name
  not_converged = 3,     ///< no equilibrium found, or none can exist
  unstable = 4,          ///< only an equilibrium that is not a minimum was found
  cancelled = 5,
  io_error = 6,       ///< a file could not be read or written
  out_of_memory = 7,  ///< there is no more
  internal_error = 8  ///< a fault of this program
};

struct AnswerStatus {
  StatusCode code = StatusCode::success;
  std::string message;  ///< what was wrong and what to do about it
};

/// What is told of an exception: the code of its kind (kindOf()), and its message; of a fault of this program
/// that it is one.
AnswerStatus answerStatus(const std::exception& error);

}  // namespace cable_variation
