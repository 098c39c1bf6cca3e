#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace cable_variation {

/// Reads a table of numbers or the like: `take` gets each line that has more than blanks, without its end and
/// what stands behind a #. Of the file, however large, no more than a line is kept. A byte order mark of
/// UTF-8 is left out.
/// Throws std::invalid_argument: "PATH: " and what RegularFile says, "PATH:LINE: " and what `take` throws as
/// std::invalid_argument, that a line is longer than any such line, or that the file is in UTF-16.
void readDataLines(const std::string& path, std::uintmax_t most_bytes,
                   const std::function<void(const std::string& line)>& take);

}  // namespace cable_variation
