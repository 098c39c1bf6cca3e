#pragma once  // internal to report/

#include <string>
#include <utility>
#include <vector>

namespace cable_variation {

/// A quantity along a cable.
struct ProfileLine {
  std::string label;
  std::string style;  ///< CSS of its stroke
  std::vector<std::pair<double, double>>
      points;  ///< in order; what is not finite or off the scale interrupts
};

struct ProfileChart {
  std::string x_title, y_title;  ///< with their units
  std::vector<ProfileLine> lines;
  std::vector<std::pair<double, std::string>> marks;   ///< places along x, with their names
  std::vector<std::pair<double, std::string>> limits;  ///< of y, dashed red
  double least = 0.0;                                  ///< of y: shown at least from here ...
  double most = 0.0;                                   ///< ... and no further than to here; 0: all of it
};

/// Lines over axes with ticks; an SVG element.
std::string profileChart(const ProfileChart& chart);

}  // namespace cable_variation
