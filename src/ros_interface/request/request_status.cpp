#include <ros_interface/request/request_status.h>

#include <string>

#include <cable_variation/util/error.h>

namespace cable_variation_ros {

using cable_variation::ErrorKind;
using cable_variation::Status;

namespace {

std::uint8_t codeOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::invalid_input:
      return Status::INVALID_ARGUMENT;
    case ErrorKind::not_found:
      return Status::NOT_FOUND;
    case ErrorKind::not_converged:
    case ErrorKind::impossible:
      return Status::NOT_CONVERGED;
    case ErrorKind::unstable:
      return Status::UNSTABLE;
    case ErrorKind::file_error:
      return Status::IO_ERROR;
    case ErrorKind::out_of_memory:
      return Status::OUT_OF_MEMORY;
    case ErrorKind::cancelled:
      return Status::CANCELLED;
    case ErrorKind::internal:
      break;
  }
  return Status::INTERNAL_ERROR;
}

std::string messageOf(const std::exception& error, ErrorKind kind) {
  if (kind == ErrorKind::out_of_memory)
    return "there is no memory left for it";  // std::bad_alloc says no more
  if (kind != ErrorKind::internal) return error.what();
  return std::string("a fault of this program, please report it with the request and the scene: ") +
         error.what();
}

}  // namespace

Status statusOf(const std::exception& error) {
  const ErrorKind kind = cable_variation::kindOf(error);
  Status status;
  status.code = codeOf(kind);
  status.message = messageOf(error, kind);
  return status;
}

Status runRequest(const std::function<void()>& body) {
  try {
    body();
  } catch (const std::exception& error) {
    return statusOf(error);
  }
  return Status();  // SUCCESS
}

}  // namespace cable_variation_ros
