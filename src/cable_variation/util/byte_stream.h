#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace cable_variation {

/// Puts numbers into bytes as this machine has them.
class ByteWriter {
 public:
  template <typename Number>
  void write(Number number) {
    static_assert(std::is_arithmetic_v<Number>);
    write(&number, 1);
  }
  template <typename Number>
  void write(const Number* numbers, std::size_t count) {
    static_assert(std::is_arithmetic_v<Number>);
    bytes_.append(reinterpret_cast<const char*>(numbers), count * sizeof(Number));
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads them again. Throws std::invalid_argument where there are fewer.
class ByteReader {
 public:
  /// @param bytes must outlive the reader
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename Number>
  Number read() {
    Number number;
    read(&number, 1);
    return number;
  }
  template <typename Number>
  void read(Number* numbers, std::size_t count) {
    static_assert(std::is_arithmetic_v<Number>);
    const std::string_view some = take(count * sizeof(Number));
    std::memcpy(numbers, some.data(), some.size());
  }
  std::string_view take(std::size_t count);
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

/// CRC-32 of some bytes, as zip and Ethernet have it: tells whether they are as they were written.
std::uint32_t checksum(std::string_view bytes);

}  // namespace cable_variation
