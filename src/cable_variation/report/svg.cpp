#include <cable_variation/report/svg.h>

#include <cmath>

#include <cable_variation/report/markup.h>

namespace cable_variation::svg {

std::string pixels(double value) {
  const double rounded = std::round(10.0 * value) / 10.0;
  const std::string text = std::to_string(rounded == 0.0 ? 0.0 : rounded);
  return text.substr(0, text.find('.') + 2);
}

std::string element(double width, double height, const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + pixels(width) + "\" height=\"" +
         pixels(height) + "\" viewBox=\"0 0 " + pixels(width) + " " + pixels(height) + "\" role=\"img\">\n" +
         content + "</svg>\n";
}

std::string text(double x, double y, const char* anchor, const std::string& content) {
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" text-anchor=\"" + anchor + "\">" +
         escaped(content) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& style) {
  return "<line x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) + "\" x2=\"" + pixels(x2) + "\" y2=\"" +
         pixels(y2) + "\" style=\"" + style + "\"/>\n";
}

std::string rectangle(double x, double y, double width, double height, const std::string& style) {
  return "<rect x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" width=\"" + pixels(width) + "\" height=\"" +
         pixels(height) + "\" style=\"" + style + "\"/>\n";
}

}  // namespace cable_variation::svg
