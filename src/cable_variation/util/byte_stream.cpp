#include <cable_variation/util/byte_stream.h>

#include <stdexcept>

#include <boost/crc.hpp>

namespace cable_variation {

std::string_view ByteReader::take(std::size_t count) {
  if (count > bytes_.size()) {
    throw std::invalid_argument(std::to_string(bytes_.size()) + " bytes are left; expected " +
                                std::to_string(count));
  }
  const std::string_view some = bytes_.substr(0, count);
  bytes_.remove_prefix(count);
  return some;
}

std::uint32_t checksum(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

}  // namespace cable_variation
