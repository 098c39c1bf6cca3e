#pragma once

#include <exception>
#include <functional>

#include <cable_variation/Status.h>

#include <cable_variation/analysis/answer_status.h>

namespace cable_variation_ros {

/// As a message.
cable_variation::Status toStatus(const cable_variation::AnswerStatus& answer);

/// What a client is told of an exception, see cable_variation::answerStatus().
cable_variation::Status statusOf(const std::exception& error);

/// Runs the body of a service handler: SUCCESS, or statusOf() what it threw.
cable_variation::Status runRequest(const std::function<void()>& body);

/// The response that `body` makes, whose status may tell of files that could not be written; if it throws,
/// one that has nothing but the status.
template <typename Response>
Response answered(const std::function<Response()>& body) {
  Response response;
  const cable_variation::Status status = runRequest([&] { response = body(); });
  if (status.code != cable_variation::Status::SUCCESS) response.status = status;
  return response;
}

}  // namespace cable_variation_ros
