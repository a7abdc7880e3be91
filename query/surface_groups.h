#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "query/duplicate_search.h"
#include "query/duplicates.h"
#include "store/shape_store.h"

namespace mdbd {

/// Rows of models of one shape; those without a duplicate are groups of their own.
using RowGroups = std::vector<std::vector<std::size_t>>;

/// The records of rows, read when they are first asked for.
class RowRecords {
 public:
  RowRecords(const ShapeStore& store, const DuplicateSearch& search)
      : store_(store), search_(search) {}

  /// Nothing if the model was removed meanwhile, or failed.
  const ShapeRecord* find(std::size_t row);

  /// Leaves out what is not there, and puts the model to keep first: a surface rather than a point
  /// cloud, of those the file that was changed last the longest ago, then the one with the shortest
  /// path. The others are ordered by path.
  void order(std::vector<std::size_t>& group);

  /// Whether the files have the same content, of which both are the same solid.
  bool have_same_bytes(std::size_t left, std::size_t right);

 private:
  const ShapeStore& store_;
  const DuplicateSearch& search_;
  std::unordered_map<std::size_t, std::optional<ShapeRecord>> records_;
};

/// Judges groups that were made by signatures by the surfaces of their models.
class SurfaceGroups {
 public:
  SurfaceGroups(const DuplicateSearch& search, RowRecords& records, const DuplicateOptions& options)
      : search_(search), records_(records), options_(options) {}

  /// Takes models out of a group whose surfaces deviate from that of the model to keep; joins
  /// groups that are near each other, as far as DuplicateOptions say, and whose surfaces agree.
  /// What cannot be measured stays as it is.
  RowGroups judge(const RowGroups& groups);

  /// The deviation of a pair if it was measured.
  std::optional<double> deviation(std::size_t left, std::size_t right) const;

  std::size_t measured() const { return deviations_.size() - not_measured_; }
  std::size_t not_measured() const { return not_measured_; }

 private:
  using RowPair = std::pair<std::size_t, std::size_t>;  // the smaller row first

  RowGroups split(const RowGroups& groups);
  RowGroups join(const RowGroups& groups);
  std::vector<RowPair> doubtful_pairs(const RowGroups& groups) const;
  void measure(const std::vector<RowPair>& pairs);

  const DuplicateSearch& search_;
  RowRecords& records_;
  const DuplicateOptions& options_;
  std::map<RowPair, std::optional<double>> deviations_;
  std::size_t not_measured_ = 0;
};

/// Groups of the rows that pairs join, directly or through others; ordered by their first row.
RowGroups join_rows(std::size_t rows,
                    const std::vector<std::pair<std::size_t, std::size_t>>& pairs);

}  // namespace mdbd
