#include <ros_interface/request/request_status.h>

#include <cable_variation/analysis/answer_status.h>

namespace cable_variation_ros {

using cable_variation::Status;
using cable_variation::StatusCode;

namespace {

constexpr bool same(StatusCode code, std::uint8_t of_message) {
  return static_cast<std::uint8_t>(code) == of_message;
}
static_assert(same(StatusCode::success, Status::SUCCESS) &&
              same(StatusCode::invalid_argument, Status::INVALID_ARGUMENT) &&
              same(StatusCode::not_found, Status::NOT_FOUND) &&
              same(StatusCode::not_converged, Status::NOT_CONVERGED) &&
              same(StatusCode::unstable, Status::UNSTABLE) &&
              same(StatusCode::cancelled, Status::CANCELLED) &&
              same(StatusCode::io_error, Status::IO_ERROR) &&
              same(StatusCode::out_of_memory, Status::OUT_OF_MEMORY) &&
              same(StatusCode::internal_error, Status::INTERNAL_ERROR));

}  // namespace

Status toStatus(const cable_variation::AnswerStatus& answer) {
  Status status;
  status.code = static_cast<std::uint8_t>(answer.code);
  status.message = answer.message;
  return status;
}

Status statusOf(const std::exception& error) { return toStatus(cable_variation::answerStatus(error)); }

Status runRequest(const std::function<void()>& body) {
  try {
    body();
  } catch (const std::exception& error) {
    return statusOf(error);
  }
  return Status();  // SUCCESS
}

}  // namespace cable_variation_ros
