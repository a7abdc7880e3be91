#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace mdbd {

using Rgb = std::array<std::uint8_t, 3>;
using Rgba = std::array<std::uint8_t, 4>;  ///< with opacity, by which the colour is not multiplied

/// A PNG file of an image whose pixels are indices into a palette.
/// @param pixels width · height of them, row after row from the top
/// @param palette at most 256 colours
/// @pre width and height are at least 1, and every pixel is below the size of the palette
/// @throws InvalidInput if the image is too large
std::string encode_png(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                       std::span<const Rgb> palette);
std::string encode_png(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                       std::span<const Rgba> palette);

/// Bytes as text (RFC 4648, section 4).
std::string encode_base64(std::string_view bytes);

}  // namespace mdbd
