#include "reference_case.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <equilibrium/cases.h>

namespace cable_variation::bench {

ReferenceCase referenceCase(char name) {
  ReferenceCase reference{name == 'H' ? test::caseH() : test::caseW(), {}, {}};
  const std::string path =
      std::string(CABLE_VARIATION_SOURCE_DIR) + "/test/data/reference/case_" + name + ".csv";
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    double s, x, y, z;
    numbers >> s >> x >> y >> z;
    reference.arc_lengths.push_back(s);
    reference.positions.emplace_back(x, y, z);
  }
  return reference;
}

double deviation(const ReferenceCase& reference, const CableShape& shape) {
  double largest = 0.0;
  for (std::size_t i = 0; i < reference.arc_lengths.size(); ++i) {
    largest = std::max(largest, (shape.position(reference.arc_lengths[i]) - reference.positions[i]).norm());
  }
  return largest;
}

}  // namespace cable_variation::bench
