#include <cable_variation/report/picture/png.h>

#include <stdexcept>

#include <png.h>

#include <cable_variation/util/error.h>

namespace cable_variation {

std::string png(const Pixels& pixels) {
  if (pixels.rgba.empty() || pixels.rgba.size() != 4 * pixels.width * pixels.height) {
    throw std::invalid_argument("a picture of " + std::to_string(pixels.width) + " by " +
                                std::to_string(pixels.height) + " pixels has " +
                                std::to_string(pixels.rgba.size()) + " bytes; expected four a pixel");
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.width);
  image.height = static_cast<png_uint_32>(pixels.height);
  image.format = PNG_FORMAT_RGBA;
  std::string file(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = file.size();
  if (png_image_write_to_memory(&image, file.data(), &size, 0, pixels.rgba.data(), 0, nullptr) == 0) {
    throw InternalError("a picture cannot be written as PNG: " + std::string(image.message));
  }
  file.resize(size);
  return file;
}

}  // namespace cable_variation
