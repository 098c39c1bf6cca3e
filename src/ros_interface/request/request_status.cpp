#include <ros_interface/request/request_status.h>

#include <new>
#include <string>

#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/readable_text.h>

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

/// Names in a request may be of any length and any bytes; a scene's faults, a line each, have been made
/// readable.
std::string readable(const std::exception& error) {
  if (dynamic_cast<const cable_variation::SceneError*>(&error) != nullptr) return error.what();
  return cable_variation::readableText(error.what());
}

std::string messageOf(const std::exception& error, ErrorKind kind) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "there is no memory left for it";  // that says no more
  if (kind != ErrorKind::internal) return readable(error);
  return std::string("a fault of this program, please report it with the request and the scene: ") +
         readable(error);
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
