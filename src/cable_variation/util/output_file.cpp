#include <cable_variation/util/output_file.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

#include <cable_variation/util/error.h>

namespace cable_variation {

namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw FileError("file '" + path + "' cannot be written: " + std::strerror(error));
}

// Opens a file that was not there before, under a name that nobody else has: `path` is that name then.
int openNew(std::string& path) {
  constexpr mode_t kAll = 0666;  // less what the process's mask takes away
  const std::string wanted = path;
  std::random_device random;
  for (;;) {
    char number[24];
    std::snprintf(number, sizeof number, ".%08x%08x.part", random(), random());
    path = wanted + number;
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kAll);
    if (file >= 0 || errno != EEXIST) return file;
  }
}

// 0, or what the system says.
int writeAll(int file, const std::string& contents) {
  for (std::size_t done = 0; done < contents.size();) {
    const ssize_t some = ::write(file, contents.data() + done, contents.size() - done);
    if (some < 0 && errno == EINTR) continue;
    if (some < 0) return errno;
    done += static_cast<std::size_t>(some);
  }
  return ::fsync(file) == 0 ? 0 : errno;
}

// So that the name outlives a loss of power. Some file systems do not know it of folders: no matter.
void bringToDisk(const std::filesystem::path& folder) {
  const int opened = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  ::fsync(opened);
  ::close(opened);
}

}  // namespace

StagedFile::StagedFile(std::string path, const std::string& contents)
    : path_(std::move(path)), temporary_(path_) {
  const int file = openNew(temporary_);
  if (file < 0) fail(path_, errno);
  int error = writeAll(file, contents);
  if (::close(file) != 0 && error == 0) error = errno;
  if (error == 0) return;
  ::unlink(temporary_.c_str());
  fail(path_, error);
}

StagedFile::~StagedFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : path_(std::move(other.path_)), temporary_(std::move(other.temporary_)) {
  other.temporary_.clear();
}

void StagedFile::commit(std::vector<StagedFile>& files) {
  for (StagedFile& file : files) {
    if (file.temporary_.empty()) continue;
    if (std::rename(file.temporary_.c_str(), file.path_.c_str()) != 0) fail(file.path_, errno);
    file.temporary_.clear();
  }
  if (!files.empty()) bringToDisk(std::filesystem::path(files.back().path_).parent_path());
}

void writeFile(const std::string& path, const std::string& contents) {
  std::vector<StagedFile> file;
  file.emplace_back(path, contents);
  StagedFile::commit(file);
}

}  // namespace cable_variation
