#include "picture/encode_png.h"

#include <vector>

#include <catch2/catch.hpp>
#include <png.h>

using mdbd::encode_base64;
using mdbd::encode_png;
using mdbd::Rgb;

namespace {

struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<Rgb> pixels;
};

Image decode(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, file.data(), file.size()) != 0);
  image.format = PNG_FORMAT_RGB;
  Image decoded = {image.width, image.height, {}};
  decoded.pixels.resize(decoded.width * decoded.height);
  REQUIRE(png_image_finish_read(&image, nullptr, decoded.pixels.data(), 0, nullptr) != 0);
  return decoded;
}

std::vector<Rgb> grey_ramp() {
  std::vector<Rgb> palette;
  for (int i = 0; i < 256; ++i) {
    const auto grey = static_cast<std::uint8_t>(i);
    palette.push_back({grey, static_cast<std::uint8_t>(255 - i), 7});
  }
  return palette;
}

}  // namespace

TEST_CASE("an image decodes to the pixels that were encoded") {
  const std::vector<Rgb> palette = grey_ramp();
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {2, 3}, {257, 100}, {1000, 1000}}) {
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width) * height);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      pixels[i] = static_cast<std::uint8_t>(i * i / 7);
    const Image image = decode(encode_png(pixels, width, height, palette));
    REQUIRE(image.width == static_cast<std::size_t>(width));
    REQUIRE(image.height == static_cast<std::size_t>(height));
    bool is_same = true;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      is_same = is_same && image.pixels[i] == palette[pixels[i]];
    }
    CHECK(is_same);
  }
}

TEST_CASE("small palettes serve") {
  const std::vector<Rgb> palette = {{1, 2, 3}, {200, 100, 50}};
  const std::vector<std::uint8_t> pixels = {0, 1, 1, 0};
  CHECK(decode(encode_png(pixels, 2, 2, palette)).pixels ==
        std::vector<Rgb>{palette[0], palette[1], palette[1], palette[0]});
}

TEST_CASE("base64 as in RFC 4648, section 10") {
  CHECK(encode_base64("").empty());
  CHECK(encode_base64("f") == "Zg==");
  CHECK(encode_base64("fo") == "Zm8=");
  CHECK(encode_base64("foo") == "Zm9v");
  CHECK(encode_base64("foob") == "Zm9vYg==");
  CHECK(encode_base64("fooba") == "Zm9vYmE=");
  CHECK(encode_base64("foobar") == "Zm9vYmFy");
  CHECK(encode_base64("\xff\xfe\xfd") == "//79");
}
