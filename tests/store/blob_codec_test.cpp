#include "store/blob_codec.h"

#include <limits>

#include <catch2/catch.hpp>

using namespace mdbd;

namespace {

Blob bytes(std::initializer_list<int> values) {
  Blob blob;
  for (const int value : values) blob.push_back(static_cast<std::byte>(value));
  return blob;
}

}  // namespace

// The bytes of schema 1: they change only together with the schema.
TEST_CASE("vectors are little-endian float32") {
  const std::vector<float> values = {1.0F, -2.5F};
  CHECK(encode_floats(values) == bytes({0, 0, 0x80, 0x3f, 0, 0, 0x20, 0xc0}));
}

TEST_CASE("balls are little-endian float64 x, y, z, r") {
  const std::vector<Ball> balls = {{{1.0, -2.0, 0.0}, 0.5}};
  CHECK(encode_balls(balls) ==
        bytes({0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0, 0, 0, 0, 0, 0, 0x00, 0xc0,  //
               0, 0, 0, 0, 0, 0, 0x00, 0x00, 0, 0, 0, 0, 0, 0, 0xe0, 0x3f}));
}

TEST_CASE("extreme numbers come back to the bit") {
  using Single = std::numeric_limits<float>;
  using Double = std::numeric_limits<double>;
  const std::vector<float> values = {Single::denorm_min(), Single::max(), -0.0F, 1.0F / 3.0F};
  CHECK(encode_floats(decode_floats(encode_floats(values))) == encode_floats(values));
  CHECK(decode_floats(encode_floats(values)) == values);
  const std::vector<Ball> balls = {{{Double::denorm_min(), -Double::max(), -0.0}, 1.0 / 3.0}};
  const std::vector<Ball> read = decode_balls(encode_balls(balls));
  REQUIRE(read.size() == 1);
  CHECK(read[0].center == balls[0].center);
  CHECK(read[0].radius == balls[0].radius);
  CHECK(encode_balls(read) == encode_balls(balls));
}

TEST_CASE("nothing is no bytes") {
  CHECK(encode_floats({}).empty());
  CHECK(encode_balls({}).empty());
  CHECK(decode_floats({}).empty());
  CHECK(decode_balls({}).empty());
}
