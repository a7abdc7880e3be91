#include "picture/encode_png.h"

#include <algorithm>

#include <fmt/format.h>
#include <png.h>

#include "features/core/errors.h"

namespace mdbd {
namespace {

/// @param format of the palette, in libpng's terms
std::string encode(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                   png_uint_32 format, std::size_t colours, const void* palette) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  image.colormap_entries = static_cast<png_uint_32>(colours);
  // Asking for the size would compress everything once more.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(size, '\0');
  if (png_image_write_to_memory(&image, file.data(), &size, 0, pixels.data(), 0, palette) == 0) {
    throw InvalidInput(
        fmt::format("cannot write an image of {} x {} pixels: {}", width, height, image.message));
  }
  file.resize(size);
  return file;
}

}  // namespace

std::string encode_png(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                       std::span<const Rgb> palette) {
  return encode(pixels, width, height, PNG_FORMAT_RGB_COLORMAP, palette.size(), palette.data());
}

std::string encode_png(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                       std::span<const Rgba> palette) {
  return encode(pixels, width, height, PNG_FORMAT_RGBA_COLORMAP, palette.size(), palette.data());
}

std::string encode_base64(std::string_view bytes) {
  constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t start = 0; start < bytes.size(); start += 3) {
    const std::size_t count = std::min<std::size_t>(bytes.size() - start, 3);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      group = group << 8 | (i < count ? static_cast<unsigned char>(bytes[start + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i <= count ? alphabet[group >> (18 - 6 * i) & 63] : '=';
    }
  }
  return text;
}

}  // namespace mdbd
