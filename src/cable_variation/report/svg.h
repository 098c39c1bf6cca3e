#pragma once  // internal to report/

#include <string>

namespace cable_variation::svg {

/// A length or coordinate [px] as an attribute.
std::string pixels(double value);

/// The whole picture [px].
std::string element(double width, double height, const std::string& content);

/// @param anchor start, middle or end @param content plain text
std::string text(double x, double y, const char* anchor, const std::string& content);

/// @param style CSS
std::string line(double x1, double y1, double x2, double y2, const std::string& style);

/// @param style CSS
std::string rectangle(double x, double y, double width, double height, const std::string& style);

}  // namespace cable_variation::svg
