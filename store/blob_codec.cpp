#include "store/blob_codec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace mdbd {
namespace {

static_assert(std::numeric_limits<float>::is_iec559 && sizeof(float) == bytes_per_float);
static_assert(std::numeric_limits<double>::is_iec559 && 4 * sizeof(double) == bytes_per_ball);

template <typename Number>
using Bytes = std::array<std::byte, sizeof(Number)>;

template <typename Number>
void append(Blob& blob, Number value) {
  auto bytes = std::bit_cast<Bytes<Number>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  blob.insert(blob.end(), bytes.begin(), bytes.end());
}

template <typename Number>
Number number_at(std::span<const std::byte> blob, std::size_t index) {
  Bytes<Number> bytes;
  std::copy_n(blob.begin() + index * sizeof(Number), sizeof(Number), bytes.begin());
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

}  // namespace

Blob encode_floats(std::span<const float> values) {
  Blob blob;
  blob.reserve(values.size() * bytes_per_float);
  for (const float value : values) append(blob, value);
  return blob;
}

Blob encode_balls(std::span<const Ball> balls) {
  Blob blob;
  blob.reserve(balls.size() * bytes_per_ball);
  for (const Ball& ball : balls) {
    for (const double coordinate : ball.center) append(blob, coordinate);
    append(blob, ball.radius);
  }
  return blob;
}

std::vector<float> decode_floats(std::span<const std::byte> bytes) {
  std::vector<float> values(bytes.size() / bytes_per_float);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = number_at<float>(bytes, i);
  return values;
}

std::vector<Ball> decode_balls(std::span<const std::byte> bytes) {
  std::vector<Ball> balls(bytes.size() / bytes_per_ball);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      balls[i].center[axis] = number_at<double>(bytes, 4 * i + axis);
    }
    balls[i].radius = number_at<double>(bytes, 4 * i + 3);
  }
  return balls;
}

}  // namespace mdbd
