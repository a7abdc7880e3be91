#include "store/vector_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "features/core/errors.h"

namespace mdbd {

const VectorArrays& VectorTable::arrays() const {
  checked(arrays_.values);
  read_models();
  return arrays_;
}

void VectorTable::read_models() const {
  checked(arrays_.ids);
  checked(arrays_.scales);
  checked(arrays_.path_ends);
  checked(std::span(arrays_.paths));
}

struct VectorTableBuilder::Rows {
  std::size_t dimension = 0;
  std::vector<std::int64_t> ids;
  std::vector<double> scales;
  std::vector<std::uint64_t> path_ends;
  std::string paths;
  std::vector<float> values;
  float largest_number = 0.0F;
  double largest_magnitude = 0.0;

  void measure(std::span<const float> vector) {
    double sum = 0.0;
    for (const float value : vector) {
      const float magnitude = std::abs(value);
      sum += magnitude;
      largest_number = std::max(largest_number, magnitude);
    }
    // A sum of finite floats is finite, one with a NaN is none.
    if (!std::isfinite(sum)) largest_number = std::numeric_limits<float>::infinity();
    largest_magnitude = std::max(largest_magnitude, sum);
  }
};

VectorTableBuilder::VectorTableBuilder() : rows_(std::make_shared<Rows>()) {}

void VectorTableBuilder::append(const StoredVector& vector) {
  Rows& rows = *rows_;
  if (rows.ids.empty()) rows.dimension = vector.values.size();
  if (vector.values.size() != rows.dimension) {
    throw InvalidInput(std::string(vector.path) + ": its vector has " +
                       std::to_string(vector.values.size()) + " numbers, and the others have " +
                       std::to_string(rows.dimension));
  }
  rows.ids.push_back(vector.shape_id);
  rows.scales.push_back(vector.scale);
  rows.paths += vector.path;
  rows.path_ends.push_back(rows.paths.size());
  rows.values.insert(rows.values.end(), vector.values.begin(), vector.values.end());
  rows.measure(vector.values);
}

VectorTable VectorTableBuilder::take() {
  const std::shared_ptr<const Rows> rows = std::exchange(rows_, std::make_shared<Rows>());
  return VectorTable({.dimension = rows->dimension,
                      .ids = rows->ids,
                      .scales = rows->scales,
                      .path_ends = rows->path_ends,
                      .paths = rows->paths,
                      .values = rows->values,
                      .largest_number = rows->largest_number,
                      .largest_magnitude = rows->largest_magnitude},
                     rows);
}

}  // namespace mdbd
