#include <limits>

#include <cable_variation/report/csv.h>
#include <cable_variation/report/path_section.h>

namespace cable_variation {

using csv::number;

namespace {

std::string titles(const Scene& scene) {
  const auto column = [](const std::string& name) { return "," + csv::text(name); };
  std::string row = "time [s],way [m],smallest_eigenvalue [N/m]";
  for (const Measure& measure : scene.measures) row += column(measure.name + " [" + measure.unit + "]");
  for (const Clip& clip : scene.harness.clips) {
    for (const char* part : {" Fx [N]", " Fy [N]", " Fz [N]", " Mx [N m]", " My [N m]", " Mz [N m]"})
      row += column(clip.name + part);
  }
  for (const Cable& cable : scene.harness.cables) row += column(cable.name + " bend radius [m]");
  return row + ",note\r\n";
}

}  // namespace

std::string pathCsv(const Scene& scene, const PathCheck& check) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::string table = titles(scene);
  for (const PathSample& sample : check.samples) {
    table += number(sample.time) + "," + number(sample.length) + "," + number(sample.smallest_eigenvalue);
    for (std::size_t i = 0; i < scene.measures.size(); ++i)
      table += "," + number(sample.solved ? sample.measures[i].value : kNaN);
    for (std::size_t i = 0; i < scene.harness.clips.size(); ++i) {
      for (int k = 0; k < 3; ++k) table += "," + number(sample.solved ? sample.reactions[i].force[k] : kNaN);
      for (int k = 0; k < 3; ++k) table += "," + number(sample.solved ? sample.reactions[i].moment[k] : kNaN);
    }
    for (std::size_t i = 0; i < scene.harness.cables.size(); ++i)
      table += "," + number(sample.solved ? sample.bends[i].radius : kNaN);
    table += "," + csv::text(sample.message) + "\r\n";
  }
  return table;
}

}  // namespace cable_variation
