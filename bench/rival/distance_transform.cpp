#include "bench/rival/distance_transform.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace mdbd::bench {
namespace {

// Lines beside each other that are transformed together: a cache line of values.
constexpr std::size_t batch = 16;

// Replaces the values f of a line by min_q f(q) + (p - q)^2: the lower envelope of parabolas.
class LineTransform {
 public:
  explicit LineTransform(std::size_t length) : parabolas_(length), ends_(length), result_(length) {
    half_inverses_.push_back(0.0F);
    for (std::size_t i = 1; i < length; ++i) half_inverses_.push_back(0.5F / static_cast<float>(i));
  }

  // Zeros stay, and no parabola reaches across one: each run between zeros is for itself.
  void apply(std::span<float> line) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (line[i] == 0.0F) continue;
      std::size_t end = i + 1;
      while (line[end] != 0.0F) ++end;
      if (end - i == 1) {
        line[i] = 1.0F;
      } else {
        apply_to_run(line.subspan(i - 1, end - i + 2));
      }
      i = end;
    }
  }

 private:
  void apply_to_run(std::span<float> run) {
    std::size_t last = 0;  // the parabola of the envelope that is farthest right
    parabolas_[0] = 0;
    for (std::size_t q = 1; q < run.size(); ++q) {
      float begin = cut(run, parabolas_[last], q);
      while (last > 0 && begin <= ends_[last - 1]) begin = cut(run, parabolas_[--last], q);
      ends_[last] = begin;
      parabolas_[++last] = q;
    }
    ends_[last] = std::numeric_limits<float>::infinity();
    std::size_t current = 0;
    for (std::size_t p = 1; p + 1 < run.size(); ++p) {
      while (ends_[current] < static_cast<float>(p)) ++current;
      const std::size_t q = parabolas_[current];
      const float offset = static_cast<float>(p) - static_cast<float>(q);
      result_[p] = run[q] + offset * offset;
    }
    std::copy_n(result_.begin() + 1, run.size() - 2, run.begin() + 1);
  }

  // Where the parabola of q falls below that of p < q.
  float cut(std::span<const float> run, std::size_t p, std::size_t q) const {
    const auto at_p = run[p] + static_cast<float>(p * p);
    const auto at_q = run[q] + static_cast<float>(q * q);
    return (at_q - at_p) * half_inverses_[q - p];
  }

  std::vector<std::size_t> parabolas_;
  std::vector<float> ends_;
  std::vector<float> result_;
  std::vector<float> half_inverses_;
};

// Squared distances from the voxels outside in the same row.
void transform_rows(std::span<const std::uint8_t> is_inside, std::size_t row_length,
                    std::span<float> values) {
  for (std::size_t row = 0; row < values.size(); row += row_length) {
    std::size_t outside = row;
    for (std::size_t i = row + 1; i < row + row_length; ++i) {
      if (is_inside[i] != 0) continue;
      for (std::size_t j = outside + 1; j < i; ++j) {
        const auto distance = static_cast<float>(std::min(j - outside, i - j));
        values[j] = distance * distance;
      }
      outside = i;
    }
  }
}

// Transforms lines along y or z: up to `batch` that begin side by side at `first`. They are copied
// out, because memory is far slower in steps of `stride`.
class BatchTransform {
 public:
  explicit BatchTransform(std::size_t length)
      : length_(length), lines_(batch * length), transform_(length) {}

  void apply(float* first, std::size_t width, std::size_t stride) {
    bool has_inside = false;
    for (std::size_t i = 0; i < length_; ++i) {
      for (std::size_t j = 0; j < width; ++j) {
        const float value = first[i * stride + j];
        has_inside |= value != 0.0F;
        lines_[j * length_ + i] = value;
      }
    }
    if (!has_inside) return;
    for (std::size_t j = 0; j < width; ++j) {
      transform_.apply(std::span(lines_).subspan(j * length_, length_));
    }
    for (std::size_t i = 0; i < length_; ++i) {
      for (std::size_t j = 0; j < width; ++j) first[i * stride + j] = lines_[j * length_ + i];
    }
  }

 private:
  std::size_t length_;
  std::vector<float> lines_;
  LineTransform transform_;
};

// Transforms the lines of `length` values in steps of `stride` that begin in a plane of the grid.
void transform_plane(float* plane, std::size_t row_length, std::size_t length, std::size_t stride) {
  BatchTransform transform(length);
  for (std::size_t x = 0; x < row_length; x += batch) {
    transform.apply(plane + x, std::min(batch, row_length - x), stride);
  }
}

}  // namespace

std::vector<float> squared_distance_transform(std::span<const std::uint8_t> is_inside,
                                              const Eigen::Array3i& counts) {
  const auto row = static_cast<std::size_t>(counts.x());
  const std::size_t slice = row * counts.y();
  std::vector<float> values(is_inside.size(), 0.0F);
  transform_rows(is_inside, row, values);
  for (int z = 0; z < counts.z(); ++z) {
    transform_plane(values.data() + z * slice, row, counts.y(), row);
  }
  for (int y = 0; y < counts.y(); ++y) {
    transform_plane(values.data() + y * row, row, counts.z(), slice);
  }
  return values;
}

}  // namespace mdbd::bench
