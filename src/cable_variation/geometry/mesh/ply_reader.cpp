#include <cable_variation/geometry/mesh/ply_reader.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include <cable_variation/geometry/mesh/ply_header.h>
#include <cable_variation/geometry/mesh/soup_builder.h>
#include <cable_variation/util/readable_text.h>
#include <cable_variation/util/text_tokens.h>

namespace cable_variation {
namespace {

// Where numbers come from, one after the other.
class Source {
 public:
  Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual ~Source() = default;
  // Any number of the type, also one that is not finite. Throws when there is none.
  virtual double number(PlyType type) = 0;
  // At least so many numbers of the type are still there.
  virtual bool holds(std::uint64_t count, PlyType type) = 0;
  // Throws unless all is read.
  virtual void finish() = 0;
};

class BinarySource : public Source {
 public:
  BinarySource(std::string_view data, bool big_endian) : data_(data), big_endian_(big_endian) {}

  double number(PlyType type) override {
    const std::size_t size = sizeOf(type);
    if (data_.size() - at_ < size) throw std::invalid_argument("the file is cut off");
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t place = big_endian_ ? i : size - 1 - i;
      bits = (bits << 8U) | static_cast<unsigned char>(data_[at_ + place]);
    }
    at_ += size;
    switch (type) {
      case PlyType::int8:
        return static_cast<std::int8_t>(bits);
      case PlyType::int16:
        return static_cast<std::int16_t>(bits);
      case PlyType::int32:
        return static_cast<std::int32_t>(bits);
      case PlyType::float32: {
        const auto narrow = static_cast<std::uint32_t>(bits);
        float value = 0.0F;
        std::memcpy(&value, &narrow, sizeof value);
        return static_cast<double>(value);
      }
      case PlyType::float64: {
        double value = 0.0;
        std::memcpy(&value, &bits, sizeof value);
        return value;
      }
      default:
        return static_cast<double>(bits);
    }
  }
  bool holds(std::uint64_t count, PlyType type) override {
    return count <= (data_.size() - at_) / sizeOf(type);
  }
  void finish() override {
    if (at_ < data_.size()) {
      throw std::invalid_argument(std::to_string(data_.size() - at_) +
                                  " bytes follow the last element; expected the file's end");
    }
  }

 private:
  std::string_view data_;
  std::size_t at_ = 0;
  bool big_endian_;
};

class TextSource : public Source {
 public:
  TextSource(const std::string& data, std::size_t lines) : size_(data.size()), words_(data, lines + 1) {}

  double number(PlyType type) override {
    const auto word = words_.next();
    if (!word || words_.lastIsCut()) {
      throw std::invalid_argument("the file is cut off; expected another number and the line's end");
    }
    const auto value = numberIn(*word);
    const bool whole = type != PlyType::float32 && type != PlyType::float64;
    if (!value || (whole && *value != std::floor(*value))) {
      throw std::invalid_argument("line " + std::to_string(words_.line()) + ": found " + quoted(*word) +
                                  "; expected a " + (whole ? "whole" : "finite") + " number");
    }
    return *value;
  }
  bool holds(std::uint64_t count, PlyType) override { return count <= size_; }
  void finish() override {
    if (!words_.atEnd()) {
      throw std::invalid_argument("line " + std::to_string(words_.line()) +
                                  ": the file goes on behind the last element");
    }
  }

 private:
  std::size_t size_;
  TextTokens words_;
};

class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Source& source, std::size_t most_triangles)
      : header_(header), source_(source), builder_(most_triangles) {}

  TriangleMesh read() {
    bool has_faces = false;
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      try {
        if (element.name == "vertex") {
          vertices(element);
        } else if (element.name == "face") {
          faces(element);
          has_faces = true;
        } else {
          for (at_ = 0; at_ < element.count; ++at_) {
            for (const PlyProperty& property : element.properties) value(property, nullptr);
          }
        }
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(readableText(element.name) + " " + std::to_string(at_ + 1) + " of " +
                                    std::to_string(element.count) + ": " + error.what());
      }
    }
    source_.finish();
    if (!has_faces) throw std::invalid_argument("it has no faces; expected an element face");
    return builder_.take();
  }

 private:
  // Of a scalar; of a list its entries, if wanted.
  double value(const PlyProperty& property, std::vector<double>* entries) {
    if (!property.count) return source_.number(property.type);
    const double count = source_.number(*property.count);
    if (count < 0.0 || !source_.holds(static_cast<std::uint64_t>(count), property.type)) {
      throw std::invalid_argument("a list of " + std::to_string(static_cast<long long>(count)) +
                                  " entries; there are not as many in the file");
    }
    for (double i = 0.0; i < count; ++i) {
      const double entry = source_.number(property.type);
      if (entries != nullptr) entries->push_back(entry);
    }
    return count;
  }

  void vertices(const PlyElement& element) {
    std::array<std::size_t, 3> axes{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string name(1, "xyz"[i]);
      const auto found = element.find({name});
      if (!found || element.properties[*found].count) {
        throw std::invalid_argument("expected the properties x, y and z, numbers");
      }
      axes[i] = *found;
    }
    std::vector<double> values(element.properties.size());
    for (at_ = 0; at_ < element.count; ++at_) {
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(element.properties[i], nullptr);
      numbers_.push_back(builder_.vertex({values[axes[0]], values[axes[1]], values[axes[2]]}));
    }
  }

  void faces(const PlyElement& element) {
    const auto list = element.find({"vertex_indices", "vertex_index"});
    if (!list || !element.properties[*list].count) {
      throw std::invalid_argument("expected the list vertex_indices or vertex_index");
    }
    std::vector<double> entries;
    std::vector<std::uint32_t> corners;
    for (at_ = 0; at_ < element.count; ++at_) {
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (i == *list) entries.clear();
        value(element.properties[i], i == *list ? &entries : nullptr);
      }
      if (entries.size() < 3) {
        throw std::invalid_argument("it has " + std::to_string(entries.size()) +
                                    " corners; expected three or more");
      }
      corners.clear();
      for (const double entry : entries) {
        if (!(entry >= 0.0 && entry < static_cast<double>(numbers_.size()) && entry == std::floor(entry))) {
          throw std::invalid_argument("it names a vertex that is not there; expected 0 to " +
                                      std::to_string(static_cast<long long>(numbers_.size()) - 1) +
                                      ", of vertices that stand before the faces");
        }
        corners.push_back(numbers_[static_cast<std::size_t>(entry)]);
      }
      builder_.polygon(corners);
    }
  }

  const PlyHeader& header_;
  Source& source_;
  SoupBuilder builder_;
  std::vector<std::uint32_t> numbers_;  // of the file's vertices
  std::uint64_t at_ = 0;                // of the element being read
};

}  // namespace

TriangleMesh readPly(std::string_view file, std::size_t most_triangles) {
  const PlyHeader header(file);
  if (header.format != PlyHeader::Format::text) {
    BinarySource source(file.substr(header.size), header.format == PlyHeader::Format::big_endian);
    return PlyReader(header, source, most_triangles).read();
  }
  std::string text(file.substr(header.size));
  if (text.find('\n') == std::string::npos) {  // lines of old, that end with a carriage return
    for (char& c : text) c = c == '\r' ? '\n' : c;
  }
  TextSource source(text, header.lines);
  return PlyReader(header, source, most_triangles).read();
}

}  // namespace cable_variation
