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

#include "store/checked_file.h"

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

/// Vectors of one signature with their models, all of one dimension. Cheap to copy, never changed,
/// thread-safe. What is asked of a table that lies in a file is checked when it is first read: all
/// functions that give it throw DamagedFile.
class VectorTable {
 public:
  class Iterator;

  VectorTable() = default;
  /// @param owner keeps what the arrays refer to
  VectorTable(const VectorArrays& arrays, std::shared_ptr<const void> owner)
      : arrays_(arrays), owner_(std::move(owner)) {}
  /// @param file whose content the arrays are part of
  VectorTable(const VectorArrays& arrays, std::shared_ptr<const CheckedFile> file)
      : arrays_(arrays), file_(file.get()), owner_(std::move(file)) {}

  std::size_t size() const { return arrays_.ids.size(); }
  bool empty() const { return arrays_.ids.empty(); }
  std::size_t dimension() const { return arrays_.dimension; }
  float largest_number() const { return arrays_.largest_number; }
  double largest_magnitude() const { return arrays_.largest_magnitude; }

  /// All of the table, read from the file if it lies in one.
  const VectorArrays& arrays() const;
  std::span<const double> scales() const { return checked(arrays_.scales); }

  std::span<const float> values(std::size_t row) const { return checked(unchecked_values(row)); }
  double scale(std::size_t row) const { return checked(arrays_.scales.subspan(row, 1))[0]; }
  std::string_view path(std::size_t row) const {
    const std::size_t first = row == 0 ? 0 : checked(arrays_.path_ends.subspan(row - 1, 1))[0];
    const std::size_t end = checked(arrays_.path_ends.subspan(row, 1))[0];
    const std::string_view path = arrays_.paths.substr(first, end - first);
    checked(std::span(path));
    return path;
  }
  /// @pre row < size()
  StoredVector operator[](std::size_t row) const {
    return {checked(arrays_.ids.subspan(row, 1))[0], path(row), scale(row), values(row)};
  }

  /// Reads ids, scales and paths of all rows: where those of many rows, in no order, are asked for,
  /// that takes less time than to read them from a file one by one.
  void read_models() const;

  /// The values of a row will be asked for soon.
  void prefetch(std::size_t row) const {
    if (file_ != nullptr) file_->prefetch(std::as_bytes(unchecked_values(row)));
  }

  /// Iterates over arrays().
  Iterator begin() const;
  Iterator end() const;

 private:
  std::span<const float> unchecked_values(std::size_t row) const {
    return arrays_.values.subspan(row * arrays_.dimension, arrays_.dimension);
  }
  template <typename Value>
  std::span<const Value> checked(std::span<const Value> part) const {
    if (file_ != nullptr) file_->check(std::as_bytes(part));
    return part;
  }

  VectorArrays arrays_;
  const CheckedFile* file_ = nullptr;
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

inline VectorTable::Iterator VectorTable::begin() const {
  arrays();
  return {*this, 0};
}
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
