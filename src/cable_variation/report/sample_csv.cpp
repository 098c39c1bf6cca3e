#include <cable_variation/report/sample_csv.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cable_variation/report/csv.h>
#include <cable_variation/report/stability_tables.h>
#include <cable_variation/util/error.h>

namespace cable_variation {

namespace {

// A link or a pipe in the file's place goes: it is not to lead elsewhere, and nobody is to wait for it.
void clearWay(const std::string& path) {
  struct stat there = {};
  if (::lstat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode))
    ::unlink(path.c_str());
}

// Opens a file for this run alone, empty: a run of another process that writes it keeps it. -1: errno says.
int openAlone(const std::string& path) {
  constexpr mode_t kAll = 0666;  // less what the process's mask takes away
  for (;;) {
    clearWay(path);
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, kAll);
    if (file < 0) return -1;
    struct stat opened = {}, named = {};
    const bool alone = ::flock(file, LOCK_EX | LOCK_NB) == 0 && ::fstat(file, &opened) == 0;
    // Another run may have given it its name between opening and locking: then it is that one's.
    const bool ours = alone && ::stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
                      opened.st_ino == named.st_ino;
    if (ours && (!S_ISREG(opened.st_mode) || ::ftruncate(file, 0) == 0)) return file;
    const int error = errno;
    ::close(file);
    errno = error;
    if (!alone || ours) return -1;
  }
}

}  // namespace

SampleCsv::SampleCsv(const std::string& path, const Scene& scene, const std::vector<std::size_t>& variables,
                     const std::vector<std::size_t>& measures, const DesignValues& values)
    : path_(path), partial_(path + ".partial"), measures_(measures.size()) {
  errno = 0;
  const int opened = openAlone(partial_);
  if (opened < 0 && errno == EWOULDBLOCK) {
    throw FileError("file '" + partial_ + "' cannot be written: another run writes it now");
  }
  if (opened < 0) fail(partial_, errno);
  file_.reset(::fdopen(opened, "wb"));
  if (!file_) {
    const int error = errno;
    ::close(opened);
    fail(partial_, error);
  }
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
  if (std::fflush(file_.get()) != 0 || ::fsync(::fileno(file_.get())) != 0) fail(partial_, errno);
  // while it is still ours alone
  if (std::rename(partial_.c_str(), path_.c_str()) != 0) fail(path_, errno);
  stop();
}

void SampleCsv::stop() {
  requireOpen();
  errno = 0;
  if (std::fclose(file_.release()) != 0) fail(partial_, errno);
}

void SampleCsv::requireOpen() const {
  if (!file_) throw std::logic_error("the samples of '" + path_ + "' are finished already");
}

void SampleCsv::write(const std::string& line) {
  requireOpen();
  errno = 0;
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size()) fail(partial_, errno);
}

void SampleCsv::fail(const std::string& file, int error) {
  throw FileError("file '" + file + "' cannot be written: " + std::strerror(error));
}

}  // namespace cable_variation
