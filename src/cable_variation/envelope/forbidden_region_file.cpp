#include <cable_variation/envelope/forbidden_region.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include <cable_variation/util/encoded_word.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/input_limits.h>
#include <cable_variation/util/number_text.h>
#include <cable_variation/util/regular_file.h>

namespace cable_variation {
namespace {

constexpr char kFirstLine[] = "# cable_variation forbidden region, version 1";

class Reader {
 public:
  Reader(const std::string& text, const std::string& source) : text_(text), source_(source) {}

  ForbiddenRegion read() {
    std::string line;
    for (number_ = 1; std::getline(text_, line); ++number_) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (number_ == 1) {
        if (line != kFirstLine) fail("expected '" + std::string(kFirstLine) + "'");
        continue;
      }
      std::istringstream words(line);
      std::string keyword;
      if (words >> keyword) take(keyword, words);
    }
    if (number_ == 1) fail("the file is empty");
    finishPiece();
    if (!announced_) fail("the number of pieces is missing");
    if (region_.pieces.size() != *announced_) {
      fail("the file ends after " + std::to_string(region_.pieces.size()) + " pieces, expected " +
           std::to_string(*announced_));
    }
    return std::move(region_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(source_ + ":" + std::to_string(number_) + ": " + what);
  }

  void take(const std::string& keyword, std::istringstream& words) {
    if (keyword == "#") {
      takeComment(words);
    } else if (keyword == "o") {
      finishPiece();
      startPiece(word(words, "the piece's name"));
    } else if (keyword == "v") {
      if (!in_piece_) fail("a vertex before the first object");
      Eigen::Vector3d vertex;
      for (int k = 0; k < 3; ++k) vertex[k] = number(word(words, "a coordinate"), "coordinate");
      vertices_.push_back(vertex);
    } else if (keyword == "f") {
      takeFacet(words);
    } else if (keyword != "g" && keyword != "s" && keyword != "vn" && keyword != "vt" &&
               keyword != "usemtl" && keyword != "mtllib" && keyword[0] != '#') {
      fail("unknown keyword '" + keyword + "'");
    }
  }

  void takeComment(std::istringstream& words) {
    std::string key;
    if (in_piece_ || !(words >> key)) return;
    if (key == "frame") region_.frame = decoded(word(words, "the frame"));
    if (key == "inflation") region_.inflation = number(word(words, "a length"), "inflation");
    if (key == "probability") region_.probability = number(word(words, "a share"), "probability");
    if (key == "protrusion") region_.protrusion = number(word(words, "a length"), "protrusion");
    if (key == "shapes") region_.shapes = count(word(words, "a number"), "shapes");
    if (key == "pieces") announced_ = count(word(words, "a number"), "pieces");
  }

  void startPiece(const std::string& name) {
    std::string rest = name;
    const auto field = [&](const std::string& key) {
      if (rest.compare(0, key.size() + 1, key + "=") != 0) {
        fail("object '" + name +
             "': expected a name like cable=NAME;s=START..END;t=FROM..TO;branch=N;r=RADIUS");
      }
      const std::size_t end = std::min(rest.find(';'), rest.size());
      const std::string value = rest.substr(key.size() + 1, end - key.size() - 1);
      rest.erase(0, std::min(end + 1, rest.size()));
      return value;
    };
    const auto range = [&](const std::string& key, double& from, double& to) {
      const std::string value = field(key);
      const std::size_t dots = value.find("..");
      if (dots == std::string::npos) fail("object '" + name + "': '" + value + "' is no range FROM..TO");
      from = number(value.substr(0, dots), key);
      to = number(value.substr(dots + 2), key);
      if (from > to) fail("object '" + name + "': " + key + " from " + value + ", expected in order");
    };
    cable_ = decoded(field("cable"));
    range("s", start_, end_);
    range("t", from_, to_);
    branch_ = count(field("branch"), "branch");
    radius_ = number(field("r"), "r");
    if (radius_ < 0.0)
      fail("object '" + name + "': radius " + numberText(radius_) + " m, expected at least 0");
    if (!rest.empty()) fail("object '" + name + "': '" + rest + "' is too much");
    in_piece_ = true;
    first_vertex_ += vertices_.size();
    vertices_.clear();
    facets_ = 0;
  }

  void finishPiece() {
    if (!in_piece_) return;
    if (vertices_.size() < 4 || facets_ < 4) {
      fail("the object before has " + std::to_string(vertices_.size()) + " vertices and " +
           std::to_string(facets_) + " facets, expected at least 4 of each");
    }
    region_.pieces.push_back(
        {cable_, start_, end_, from_, to_, branch_, RoundedHull{ConvexHull(vertices_), radius_}});
  }

  void takeFacet(std::istringstream& words) {
    if (!in_piece_) fail("a facet before the first object");
    int corners = 0;
    for (std::string corner; words >> corner; ++corners) {
      const std::size_t vertex = count(corner.substr(0, corner.find('/')), "facet");
      if (vertex <= first_vertex_ || vertex > first_vertex_ + vertices_.size()) {
        fail("facet of vertex " + std::to_string(vertex) + ", expected one of the object's, " +
             std::to_string(first_vertex_ + 1) + " to " + std::to_string(first_vertex_ + vertices_.size()));
      }
    }
    if (corners < 3) fail("facet with " + std::to_string(corners) + " corners, expected at least 3");
    ++facets_;
  }

  std::string word(std::istringstream& words, const std::string& what) const {
    std::string next;
    if (!(words >> next)) fail("the line ends, expected " + what);
    return next;
  }

  double number(const std::string& word, const std::string& what) const {
    double value = 0.0;
    const auto [end, error] = readNumber(word, value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) {
      fail(what + ": '" + word + "' is no finite number");
    }
    return value;
  }

  std::size_t count(const std::string& word, const std::string& what) const {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) {
      fail(what + ": '" + word + "' is no whole number");
    }
    return value;
  }

  std::string decoded(const std::string& word) const {
    try {
      return decodedWord(word);
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
  }

  std::istringstream text_;
  std::string source_;
  std::size_t number_ = 1;  // of the line
  ForbiddenRegion region_;
  std::optional<std::size_t> announced_;  // pieces
  // the piece being read
  bool in_piece_ = false;
  std::string cable_;
  double start_ = 0.0, end_ = 0.0, from_ = 0.0, to_ = 0.0, radius_ = 0.0;
  std::size_t branch_ = 0, facets_ = 0;
  std::size_t first_vertex_ = 0;  // of all before it
  std::vector<Eigen::Vector3d> vertices_;
};

}  // namespace

std::string regionText(const ForbiddenRegion& region) {
  std::ostringstream text;
  text << kFirstLine << '\n'
       << "# All within its radius r of an object is forbidden. Lengths in metres, times in seconds.\n"
       << "# frame " << encodedWord(region.frame) << '\n'
       << "# inflation " << numberText(region.inflation) << '\n'
       << "# probability " << numberText(region.probability) << '\n'
       << "# shapes " << region.shapes << '\n'
       << "# protrusion " << numberText(region.protrusion) << '\n'
       << "# pieces " << region.pieces.size() << '\n';
  std::size_t first = 1;
  for (const ForbiddenRegion::Piece& piece : region.pieces) {
    text << "o cable=" << encodedWord(piece.cable) << ";s=" << numberText(piece.start) << ".."
         << numberText(piece.end) << ";t=" << numberText(piece.from) << ".." << numberText(piece.to)
         << ";branch=" << piece.branch << ";r=" << numberText(piece.body.radius) << '\n';
    const TriangleMesh& surface = piece.body.core.surface();
    for (const Eigen::Vector3d& vertex : surface.vertices) {
      text << "v " << numberText(vertex.x()) << ' ' << numberText(vertex.y()) << ' ' << numberText(vertex.z())
           << '\n';
    }
    for (const auto& [a, b, c] : surface.triangles) {
      text << "f " << first + a << ' ' << first + b << ' ' << first + c << '\n';
    }
    first += surface.vertices.size();
  }
  return text.str();
}

ForbiddenRegion parseRegion(const std::string& text, const std::string& source) {
  return Reader(text, source).read();
}

ForbiddenRegion readRegion(const std::string& path) {
  std::string text;
  try {
    text = readWhole(path, InputLimits().region_bytes);
  } catch (const std::invalid_argument& error) {
    throw FileError(path + ": " + error.what());
  }
  return parseRegion(text, path);
}

}  // namespace cable_variation
