#include <cable_variation/analysis/block_file.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cable_variation/util/byte_stream.h>
#include <cable_variation/util/error.h>

namespace cable_variation {

namespace {

const std::string kMagic = "cable_variation blocks 1\n";
// Of a record: first sample, count and length of its bytes; and the checksum of these numbers and the bytes.
constexpr std::size_t kRecordNumbers = 3 * sizeof(std::uint64_t);
constexpr std::size_t kRecordHead = kRecordNumbers + sizeof(std::uint32_t);
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 32;  // of a header or block that is one

[[noreturn]] void fail(const std::string& path, const char* what, int error) {
  throw FileError("file '" + path + "' cannot be " + what + ": " + std::strerror(error));
}

std::string recordOf(const BlockRange& range, const std::string& bytes) {
  ByteWriter numbers;
  numbers.write<std::uint64_t>(range.first);
  numbers.write<std::uint64_t>(range.count);
  numbers.write<std::uint64_t>(bytes.size());
  const std::string head = numbers.take();
  ByteWriter sum;
  sum.write(checksum(head + bytes));
  return head + sum.take() + bytes;
}

std::string textOf(const BlockFileHeader& header) {
  const auto with_length = [](const std::string& text) {
    ByteWriter length;
    length.write<std::uint64_t>(text.size());
    return length.take() + text;
  };
  ByteWriter range;
  range.write(header.first);
  range.write(header.samples);
  return range.take() + with_length(toText(header.identity)) + with_length(toText(header.request)) +
         with_length(header.scene);
}

BlockFileHeader headerFrom(const std::string& text) {
  ByteReader reader(text);
  BlockFileHeader header;
  header.first = reader.read<std::uint64_t>();
  header.samples = reader.read<std::uint64_t>();
  const auto next = [&] { return std::string(reader.take(reader.read<std::uint64_t>())); };
  header.identity = identityFrom(next());
  header.request = identityFrom(next());
  header.scene = next();
  return header;
}

}  // namespace

BlockFileReader::BlockFileReader(std::string path) : path_(std::move(path)) {
  file_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file_ < 0) fail(path_, "read", errno);
  try {
    readHeader();
    while (readRecord()) {
    }
    complete_to_ = header_.first;
    for (const auto& [range, place] : blocks_) {
      if (range.first == complete_to_) complete_to_ = range.end();
    }
  } catch (...) {
    ::close(file_);
    throw;
  }
}

bool BlockFileReader::isCutInHeader(const std::string& path) {
  std::error_code error;
  const std::uint64_t whole = std::filesystem::file_size(path, error);
  if (error) return false;  // a folder, or none
  std::string head(kMagic.size() + kRecordHead, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  const auto read = static_cast<std::size_t>(file.gcount());
  if (head.compare(0, std::min(read, kMagic.size()), kMagic, 0, read) != 0) return false;
  if (read < head.size()) return true;
  ByteReader reader(std::string_view(head).substr(kMagic.size() + 2 * sizeof(std::uint64_t)));
  const auto size = reader.read<std::uint64_t>();
  return size < kMostBytes && whole < head.size() + size;
}

BlockFileReader::~BlockFileReader() {
  if (file_ >= 0) ::close(file_);
}

BlockFileReader::BlockFileReader(BlockFileReader&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      header_(std::move(other.header_)),
      blocks_(std::move(other.blocks_)),
      end_(other.end_),
      complete_to_(other.complete_to_) {}

std::string BlockFileReader::read(std::uint64_t offset, std::uint64_t size) const {
  struct stat there = {};
  if (::fstat(file_, &there) != 0) fail(path_, "read", errno);
  const auto whole = static_cast<std::uint64_t>(there.st_size);
  if (!S_ISREG(there.st_mode) || offset >= whole) return "";
  std::string bytes(std::min(size, whole - offset), '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t some =
        ::pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (some < 0 && errno == EINTR) continue;
    if (some < 0) fail(path_, "read", errno);
    if (some == 0) bytes.resize(done);
    done += static_cast<std::size_t>(some);
  }
  return bytes;
}

void BlockFileReader::readHeader() {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument("file '" + path_ + "': " + why +
                                "; expected a file NAME.blocks of `cable_variation simulate`");
  };
  const std::size_t start = kMagic.size() + kRecordHead;
  const std::string head = read(0, start);
  if (head.size() < start || head.compare(0, kMagic.size(), kMagic) != 0)
    refuse("does not begin as a file of blocks");
  ByteReader reader(std::string_view(head).substr(kMagic.size()));
  reader.take(2 * sizeof(std::uint64_t));
  const auto size = reader.read<std::uint64_t>();
  const auto sum = reader.read<std::uint32_t>();
  const std::string text = size < kMostBytes ? read(start, size) : "";
  if (text.size() != size || checksum(head.substr(kMagic.size(), kRecordNumbers) + text) != sum)
    refuse("its header is damaged");
  try {
    header_ = headerFrom(text);
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  end_ = start + size;
}

bool BlockFileReader::readRecord() {
  const std::string head = read(end_, kRecordHead);
  if (head.size() < kRecordHead) return false;
  ByteReader reader(head);
  BlockRange range;
  range.first = reader.read<std::uint64_t>();
  range.count = reader.read<std::uint64_t>();
  const auto size = reader.read<std::uint64_t>();
  const auto sum = reader.read<std::uint32_t>();
  if (size >= kMostBytes || range.count == 0) return false;
  const std::string bytes = read(end_ + kRecordHead, size);
  if (bytes.size() != size || checksum(head.substr(0, kRecordNumbers) + bytes) != sum) return false;
  blocks_[range] = {end_ + kRecordHead, size};
  end_ += kRecordHead + size;
  return true;
}

std::string BlockFileReader::bytesOf(const BlockRange& range) const {
  const auto found = blocks_.find(range);
  if (found == blocks_.end()) return "";
  std::string bytes = read(found->second.offset, found->second.size);
  if (bytes.size() != found->second.size)
    throw FileError("file '" + path_ + "' cannot be read: it has been cut off meanwhile");
  return bytes;
}

BlockFileWriter::BlockFileWriter(std::string path, const BlockFileHeader& header) : path_(std::move(path)) {
  open();
  try {
    write(kMagic + recordOf({header.first, static_cast<std::size_t>(header.samples)}, textOf(header)));
  } catch (...) {
    ::close(file_);
    throw;
  }
}

BlockFileWriter::BlockFileWriter(std::string path, std::uint64_t end) : path_(std::move(path)), end_(end) {
  open();
}

BlockFileWriter::~BlockFileWriter() { ::close(file_); }

void BlockFileWriter::open() {
  constexpr mode_t kAll = 0666;  // less what the process's mask takes away
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, kAll);
  if (file_ < 0) fail(path_, "written", errno);
  const bool done =
      ::flock(file_, LOCK_EX | LOCK_NB) == 0 && ::ftruncate(file_, static_cast<off_t>(end_)) == 0;
  const int error = done ? 0 : errno;
  if (error == 0) return;
  ::close(file_);
  if (error == EWOULDBLOCK)
    throw FileError("file '" + path_ + "' cannot be written: another run writes it now");
  fail(path_, "written", error);
}

void BlockFileWriter::write(const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t some =
        ::pwrite(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(end_ + done));
    if (some < 0 && errno == EINTR) continue;
    if (some < 0) {
      const int error = errno;
      if (::ftruncate(file_, static_cast<off_t>(end_)) != 0) fail(path_, "written", errno);
      fail(path_, "written", error);
    }
    done += static_cast<std::size_t>(some);
  }
  end_ += bytes.size();
}

void BlockFileWriter::append(const BlockRange& range, const std::string& bytes) {
  write(recordOf(range, bytes));
}

void BlockFileWriter::sync() {
  if (::fsync(file_) != 0) fail(path_, "written", errno);
}

}  // namespace cable_variation
