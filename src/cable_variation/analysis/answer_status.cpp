#include <cable_variation/analysis/answer_status.h>

#include <new>

#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/readable_text.h>

namespace cable_variation {

namespace {

StatusCode codeOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::invalid_input:
      return StatusCode::invalid_argument;
    case ErrorKind::not_found:
      return StatusCode::not_found;
    case ErrorKind::not_converged:
    case ErrorKind::impossible:
      return StatusCode::not_converged;
    case ErrorKind::unstable:
      return StatusCode::unstable;
    case ErrorKind::file_error:
      return StatusCode::io_error;
    case ErrorKind::out_of_memory:
      return StatusCode::out_of_memory;
    case ErrorKind::cancelled:
      return StatusCode::cancelled;
    case ErrorKind::internal:
      break;
  }
  return StatusCode::internal_error;
}

/// Names in a request may be of any length and any bytes; a scene's faults, a line each, have been made
/// readable.
std::string readable(const std::exception& error) {
  if (dynamic_cast<const SceneError*>(&error) != nullptr) return error.what();
  return readableText(error.what());
}

std::string messageOf(const std::exception& error, ErrorKind kind) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "there is no memory left for it";  // that says no more
  if (kind != ErrorKind::internal) return readable(error);
  return std::string("a fault of this program, please report it with the request and the scene: ") +
         readable(error);
}

}  // namespace

AnswerStatus answerStatus(const std::exception& error) {
  const ErrorKind kind = kindOf(error);
  return {codeOf(kind), messageOf(error, kind)};
}

}  // namespace cable_variation
