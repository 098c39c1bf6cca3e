#include <cable_variation/util/error.h>

#include <filesystem>
#include <new>

namespace cable_variation {

ErrorKind kindOf(const std::exception& error) noexcept {
  if (const auto* own = dynamic_cast<const Error*>(&error)) return own->kind();
  if (dynamic_cast<const std::invalid_argument*>(&error) != nullptr) return ErrorKind::invalid_input;
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return ErrorKind::out_of_memory;
  if (dynamic_cast<const std::filesystem::filesystem_error*>(&error) != nullptr) return ErrorKind::file_error;
  return ErrorKind::internal;
}

}  // namespace cable_variation
