#include <ros_interface/request/request_status.h>

#include <cable_variation/envelope/envelope_generator.h>

namespace cable_variation_ros {

using cable_variation::Equilibrium;
using cable_variation::EquilibriumStatus;
using cable_variation::Status;

namespace {

Status makeStatus(std::uint8_t code, const std::string& message) {
  Status status;
  status.code = code;
  status.message = message;
  return status;
}

}  // namespace

Status runRequest(const std::function<void()>& body) {
  try {
    body();
  } catch (const RequestError& error) {
    return makeStatus(error.code(), error.what());
  } catch (const cable_variation::Cancelled& cancelled) {
    return makeStatus(Status::CANCELLED, cancelled.what());
  } catch (const std::invalid_argument& error) {
    return makeStatus(Status::INVALID_ARGUMENT, error.what());
  } catch (const std::exception& error) {
    return makeStatus(Status::IO_ERROR, error.what());
  }
  return makeStatus(Status::SUCCESS, "");
}

void requireConverged(const Equilibrium& equilibrium) {
  if (equilibrium.converged()) return;
  const bool unstable = equilibrium.status == EquilibriumStatus::unstable;
  throw RequestError(unstable ? Status::UNSTABLE : Status::NOT_CONVERGED,
                     std::string(toString(equilibrium.status)) + ": " + equilibrium.message);
}

}  // namespace cable_variation_ros
