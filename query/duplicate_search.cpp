#include "query/duplicate_search.h"

#include <cmath>
#include <limits>
#include <unordered_map>

#include "query/collect_vectors.h"
#include "query/duplicates.h"

namespace mdbd {

DuplicateSearch::DuplicateSearch(const ShapeStore& store, const CollectionFilter& filter,
                                 std::size_t& completed)
    : radii_metric_(similarity_metric(store.recipe().descriptor_balls, 0.0)),
      fused_(fused_metric()) {
  std::size_t none = 0;
  descriptors_ = collect_vectors(store, SignatureKind::mdbd_100, filter, {}, none);
  std::unordered_map<std::int64_t, std::size_t> rows;
  for (std::size_t row = 0; row < descriptors_.size(); ++row) {
    rows[descriptors_[row].shape_id] = row;
  }
  // Another process may have added a model between the two readings.
  VectorTableBuilder fused;
  const VectorTable all = collect_vectors(store, SignatureKind::mdbd_fused, filter, {}, completed);
  for (const StoredVector vector : all) {
    const auto row = rows.find(vector.shape_id);
    if (row == rows.end()) continue;
    fused.append(vector);
    descriptor_rows_.push_back(row->second);
  }
  search_.emplace(fused.take(), fused_metric(), descriptor_rows_.size());
}

double DuplicateSearch::distance(std::size_t left, std::size_t right) const {
  const VectorTable& vectors = search_->collection();
  return fused_->distance(vectors.values(left), vectors.values(right));
}

double DuplicateSearch::radii_distance(std::size_t left, std::size_t right) const {
  return radii_metric_->distance(descriptors_.values(descriptor_rows_[left]),
                                 descriptors_.values(descriptor_rows_[right]));
}

double DuplicateSearch::largest_radius_difference(std::size_t left, std::size_t right) const {
  return std::abs(descriptors_.values(descriptor_rows_[left]).front() -
                  descriptors_.values(descriptor_rows_[right]).front());
}

bool DuplicateSearch::are_duplicates(std::size_t left, std::size_t right, double threshold) const {
  return distance(left, right) <= threshold &&
         radii_distance(left, right) <= radii_share * threshold;
}

std::vector<std::size_t> DuplicateSearch::duplicates_of(std::size_t row, double threshold) const {
  std::vector<std::size_t> rows = nearest(row, std::numeric_limits<std::size_t>::max(), threshold);
  std::erase_if(rows, [&](std::size_t other) {
    return radii_distance(row, other) > radii_share * threshold;
  });
  return rows;
}

std::vector<std::size_t> DuplicateSearch::nearest(std::size_t row, std::size_t count,
                                                  double distance) const {
  const SearchOptions options{.count = count, .threshold = distance};
  std::vector<std::size_t> rows;
  for (const Match& match : search_->search(search_->collection().values(row), options).matches) {
    rows.push_back(match.row);
  }
  return rows;
}

}  // namespace mdbd
