#pragma once

#include <optional>
#include <string>

namespace cable_variation::csv {

/// A text in quotes, those within doubled (RFC 4180).
std::string text(const std::string& content);

/// Read back to the same double everywhere; nan where there is none.
std::string number(double value);
/// Empty without a value.
std::string number(const std::optional<double>& value);

}  // namespace cable_variation::csv
