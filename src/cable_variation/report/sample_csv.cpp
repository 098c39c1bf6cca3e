#include <cable_variation/report/sample_csv.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>

#include <unistd.h>

#include <cable_variation/report/csv.h>
#include <cable_variation/report/stability_tables.h>

namespace cable_variation {

SampleCsv::SampleCsv(const std::string& path, const Scene& scene, const std::vector<std::size_t>& variables,
                     const std::vector<std::size_t>& measures, const DesignValues& values)
    : path_(path), partial_(path + ".partial"), measures_(measures.size()) {
  errno = 0;
  file_.reset(std::fopen(partial_.c_str(), "wb"));
  if (!file_) fail(errno);
  std::string heading = "sample,outcome";
  for (const std::size_t variable : variables) {
    const DesignVariable& described = scene.design_variables[variable];
    nominal_.push_back(nominalValue(described, values));
    heading += "," + csv::text(described.name + " [" + described.unit + "]");
  }
  for (const std::size_t measure : measures) {
    heading += "," + csv::text(scene.measures[measure].name + " [" + scene.measures[measure].unit + "]");
  }
  write(heading + "\r\n");
}

void SampleCsv::add(std::uint64_t index, SampleOutcome outcome, const double* deviations,
                    const double* measured) {
  const bool has_values = hasValues(outcome);
  std::string line = std::to_string(index) + "," + toString(outcome);
  for (std::size_t i = 0; i < nominal_.size(); ++i) line += "," + csv::number(nominal_[i] + deviations[i]);
  for (std::size_t i = 0; i < measures_; ++i) {
    line += "," + csv::number(has_values ? measured[i] : std::numeric_limits<double>::quiet_NaN());
  }
  write(line + "\r\n");
}

void SampleCsv::finish() {
  requireOpen();
  errno = 0;
  if (std::fflush(file_.get()) != 0 || ::fsync(::fileno(file_.get())) != 0) fail(errno);
  stop();
  if (std::rename(partial_.c_str(), path_.c_str()) != 0) fail(errno);
}

void SampleCsv::stop() {
  requireOpen();
  errno = 0;
  if (std::fclose(file_.release()) != 0) fail(errno);
}

void SampleCsv::requireOpen() const {
  if (!file_) throw std::logic_error("the samples of '" + path_ + "' are finished already");
}

void SampleCsv::write(const std::string& line) {
  requireOpen();
  errno = 0;
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size()) fail(errno);
}

void SampleCsv::fail(int error) const {
  throw std::runtime_error("file '" + partial_ + "' cannot be written: " + std::strerror(error));
}

}  // namespace cable_variation
