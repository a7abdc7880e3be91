#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "query/collection_filter.h"
#include "query/exact_search.h"
#include "store/shape_store.h"
#include "store/vector_table.h"

namespace mdbd {

/// The models of a collection by both of their signatures. A row is a model.
class DuplicateSearch {
 public:
  /// @param completed receives QueryAnswer::completed
  /// @throws StoreError if the collection cannot be read
  DuplicateSearch(const ShapeStore& store, const CollectionFilter& filter, std::size_t& completed);

  std::size_t size() const { return search_->collection().size(); }
  std::int64_t id(std::size_t row) const { return search_->collection()[row].shape_id; }

  /// The distance by mdbd-fused.
  double distance(std::size_t left, std::size_t right) const;
  /// The part "radii" of the distance by mdbd-100.
  double radii_distance(std::size_t left, std::size_t right) const;
  /// How far the largest radii differ, relative to R.
  double largest_radius_difference(std::size_t left, std::size_t right) const;

  /// Whether the signatures say that two models are of one shape: DuplicateOptions::threshold.
  bool are_duplicates(std::size_t left, std::size_t right, double threshold) const;
  /// The rows of which they say so, the row itself among them.
  std::vector<std::size_t> duplicates_of(std::size_t row, double threshold) const;

  /// The nearest rows by mdbd-fused within a distance, the row itself among them, nearest first.
  std::vector<std::size_t> nearest(std::size_t row, std::size_t count, double distance) const;

 private:
  std::unique_ptr<const SignatureMetric> radii_metric_;
  std::unique_ptr<const SignatureMetric> fused_;
  VectorTable descriptors_;                   // mdbd-100
  std::vector<std::size_t> descriptor_rows_;  // of the rows of mdbd-fused
  std::optional<ExactSearch> search_;         // by mdbd-fused
};

}  // namespace mdbd
