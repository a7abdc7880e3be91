#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mdbd {

/// A vector of one signature with its model: a row of a VectorTable, valid as long as that.
struct StoredVector {
  std::int64_t shape_id = 0;
  std::string_view path;
  double scale = 0.0;  ///< R in object units
  std::span<const float> values;
};

/// Vectors as they lie in memory or in a file: arrays of one entry for each row, and
/// - the vectors one after the other, `dimension` numbers each;
/// - the paths one after the other, without anything between them.
struct VectorArrays {
  std::size_t dimension = 0;
  std::span<const std::int64_t> ids;
  std::span<const double> scales;
  std::span<const std::uint64_t> path_ends;  ///< where each path ends in `paths`, ascending
  std::string_view paths;
  std::span<const float> values;
  /// The largest magnitude of a number; infinite if one is not finite.
  float largest_number = 0.0F;
  /// The largest sum of the magnitudes of the numbers of a vector.
  double largest_magnitude = 0.0;
};

/// Vectors of one signature with their models, all of one dimension. Cheap to copy, never changed.
class VectorTable {
 public:
  class Iterator;

  VectorTable() = default;
  /// @param owner keeps what the arrays refer to
  VectorTable(const VectorArrays& arrays, std::shared_ptr<const void> owner)
      : arrays_(arrays), owner_(std::move(owner)) {}

  std::size_t size() const { return arrays_.ids.size(); }
  bool empty() const { return arrays_.ids.empty(); }
  std::size_t dimension() const { return arrays_.dimension; }
  const VectorArrays& arrays() const { return arrays_; }

  std::span<const float> values(std::size_t row) const {
    return arrays_.values.subspan(row * arrays_.dimension, arrays_.dimension);
  }
  double scale(std::size_t row) const { return arrays_.scales[row]; }
  std::string_view path(std::size_t row) const {
    const std::size_t first = row == 0 ? 0 : arrays_.path_ends[row - 1];
    return arrays_.paths.substr(first, arrays_.path_ends[row] - first);
  }
  /// @pre row < size()
  StoredVector operator[](std::size_t row) const {
    return {arrays_.ids[row], path(row), scale(row), values(row)};
  }

  Iterator begin() const;
  Iterator end() const;

 private:
  VectorArrays arrays_;
  std::shared_ptr<const void> owner_;
};

class VectorTable::Iterator {
 public:
  using value_type = StoredVector;
  using difference_type = std::ptrdiff_t;

  Iterator() = default;
  Iterator(const VectorTable& table, std::size_t row) : table_(&table), row_(row) {}

  StoredVector operator*() const { return (*table_)[row_]; }
  Iterator& operator++() {
    ++row_;
    return *this;
  }
  Iterator operator++(int) {
    Iterator before = *this;
    ++row_;
    return before;
  }
  bool operator==(const Iterator&) const = default;

 private:
  const VectorTable* table_ = nullptr;
  std::size_t row_ = 0;
};

inline VectorTable::Iterator VectorTable::begin() const { return {*this, 0}; }
inline VectorTable::Iterator VectorTable::end() const { return {*this, size()}; }

/// Makes a table, row by row.
class VectorTableBuilder {
 public:
  VectorTableBuilder();

  /// @throws InvalidInput if the vector has another dimension than the first
  void append(const StoredVector& vector);

  /// The table of what was appended since the last one.
  VectorTable take();

 private:
  struct Rows;
  std::shared_ptr<Rows> rows_;
};

}  // namespace mdbd
