#include <cable_variation/util/data_lines.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <cable_variation/util/regular_file.h>

namespace cable_variation {
namespace {

constexpr std::size_t kLongestLine = 10000;  // characters

// Lines of a file, read in pieces.
class Lines {
 public:
  Lines(const std::string& path, std::uintmax_t most_bytes) : file_(path, most_bytes) {}

  bool next(std::string& line) {
    line.clear();
    if (!fill()) return false;
    ++number_;
    for (bool ended = false; !ended && fill();) {
      const auto from = piece_.begin() + static_cast<std::ptrdiff_t>(at_);
      const auto to = std::find(from, piece_.end(), '\n');
      const auto count = static_cast<std::size_t>(to - from);
      if (line.size() + count > kLongestLine) {
        throw std::invalid_argument("the line has more than " + std::to_string(kLongestLine) +
                                    " characters; expected lines that end");
      }
      line.append(from, to);
      ended = to != piece_.end();
      at_ += count + (ended ? 1 : 0);
    }
    return true;
  }
  std::size_t number() const { return number_; }

 private:
  // Whether there is more.
  bool fill() {
    constexpr std::size_t kPiece = std::size_t{1} << 16U;
    if (at_ < piece_.size()) return true;
    piece_.resize(kPiece);
    piece_.resize(file_.read(piece_.data(), kPiece));
    at_ = 0;
    return !piece_.empty();
  }

  RegularFile file_;
  std::vector<char> piece_;
  std::size_t at_ = 0;  // in the piece
  std::size_t number_ = 0;
};

void removeByteOrderMark(std::string& line) {
  const std::string mark = "\xef\xbb\xbf";
  if (line.compare(0, 2, "\xff\xfe") == 0 || line.compare(0, 2, "\xfe\xff") == 0)
    throw std::invalid_argument("the file is in UTF-16; expected UTF-8");
  if (line.compare(0, mark.size(), mark) == 0) line.erase(0, mark.size());
}

}  // namespace

void readDataLines(const std::string& path, std::uintmax_t most_bytes,
                   const std::function<void(const std::string& line)>& take) {
  std::string place = path;
  try {
    Lines lines(path, most_bytes);
    for (std::string line;;) {
      place = path + ":" + std::to_string(lines.number() + 1);
      if (!lines.next(line)) return;
      if (lines.number() == 1) removeByteOrderMark(line);
      line.erase(std::min(line.find('#'), line.size()));
      if (line.find_first_not_of(" \t\r") != std::string::npos) take(line);
    }
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(place + ": " + error.what());
  }
}

}  // namespace cable_variation
