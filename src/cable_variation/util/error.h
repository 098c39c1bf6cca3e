#pragma once

#include <exception>
#include <stdexcept>
#include <string>

namespace cable_variation {

/// Why something could not be done, for who has to act on it; the message says what and where.
enum class ErrorKind {
  invalid_input,  ///< a value out of its bounds, a file with faults; more than a given limit allows
  not_found,      ///< nothing of that name
  not_converged,  ///< no equilibrium was found
  unstable,       ///< only an equilibrium that is not a minimum was found
  impossible,     ///< no equilibrium can exist
  file_error,     ///< the system could not read or write a file
  out_of_memory,  ///< the system has no more memory
  cancelled,      ///< asked for by whoever started it
  internal        ///< a fault of this program: nobody's input explains it
};

/// What the errors of this library are besides std::exceptions. Invalid input is std::invalid_argument, a
/// wrong call from within std::logic_error, without this.
class Error {
 public:
  virtual ErrorKind kind() const noexcept = 0;

 protected:
  ~Error() = default;
};

template <ErrorKind Kind>
class ErrorOf : public std::runtime_error, public Error {
 public:
  using std::runtime_error::runtime_error;
  ErrorKind kind() const noexcept final { return Kind; }
};

using NotFound = ErrorOf<ErrorKind::not_found>;
using NotConverged = ErrorOf<ErrorKind::not_converged>;
using Unstable = ErrorOf<ErrorKind::unstable>;
using Impossible = ErrorOf<ErrorKind::impossible>;
using FileError = ErrorOf<ErrorKind::file_error>;
using InternalError = ErrorOf<ErrorKind::internal>;

class Cancelled : public ErrorOf<ErrorKind::cancelled> {
 public:
  explicit Cancelled(const std::string& message = "cancelled") : ErrorOf(message) {}
};

/// Of any exception: an Error's own; std::invalid_argument is invalid input, std::bad_alloc out of memory,
/// std::filesystem::filesystem_error a file error; of whatever else nothing is known: internal.
ErrorKind kindOf(const std::exception& error) noexcept;

}  // namespace cable_variation
