#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include <cable_variation/Status.h>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation_ros {

/// A request that cannot be fulfilled, with the Status code that says why.
class RequestError : public std::runtime_error {
 public:
  RequestError(std::uint8_t code, const std::string& message) : std::runtime_error(message), code_(code) {}
  std::uint8_t code() const { return code_; }

 private:
  std::uint8_t code_;
};

/// Runs the body of a service handler: SUCCESS, or what it threw as a Status.
/// std::invalid_argument is INVALID_ARGUMENT, cable_variation::Cancelled CANCELLED, any other exception
/// IO_ERROR.
cable_variation::Status runRequest(const std::function<void()>& body);

/// Throws RequestError unless the equilibrium converged.
void requireConverged(const cable_variation::Equilibrium& equilibrium);

}  // namespace cable_variation_ros
