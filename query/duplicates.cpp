#include "query/duplicates.h"

#include <algorithm>
#include <utility>

#include "query/duplicate_search.h"
#include "query/surface_groups.h"

namespace mdbd {
namespace {

RowGroups join_by_signatures(const DuplicateSearch& search, double threshold) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t row = 0; row < search.size(); ++row) {
    for (const std::size_t other : search.duplicates_of(row, threshold)) {
      pairs.emplace_back(row, other);
    }
  }
  return join_rows(search.size(), pairs);
}

/// Describes groups, with the model to keep first.
class GroupDescriber {
 public:
  GroupDescriber(const ShapeStore& store, const DuplicateSearch& search, RowRecords& records,
                 const SurfaceGroups& surfaces, double threshold)
      : store_(store),
        search_(search),
        records_(records),
        surfaces_(surfaces),
        threshold_(threshold) {}

  DuplicateGroup describe(const std::vector<std::size_t>& rows) const {
    DuplicateGroup group;
    std::vector<std::vector<float>> chiralities;
    for (const std::size_t row : rows) {
      group.models.push_back(*records_.find(row));
      chiralities.push_back(compute_chirality(store_.data(search_.id(row)).balls));
    }
    for (std::size_t first = 0; first < rows.size(); ++first) {
      for (std::size_t second = first + 1; second < rows.size(); ++second) {
        if (first > 0 && !is_pair(rows[first], rows[second])) continue;
        DuplicatePair& pair = group.pairs.emplace_back(compare(rows[first], rows[second]));
        pair.first = first;
        pair.second = second;
        pair.hand = compare_hands(chiralities[first], chiralities[second]);
      }
    }
    return group;
  }

 private:
  bool is_pair(std::size_t left, std::size_t right) const {
    return surfaces_.deviation(left, right) || search_.are_duplicates(left, right, threshold_);
  }

  DuplicatePair compare(std::size_t left, std::size_t right) const {
    return {.distance = search_.distance(left, right),
            .radii_distance = search_.radii_distance(left, right),
            .deviation = surfaces_.deviation(left, right),
            .scale_ratio = records_.find(right)->scale / records_.find(left)->scale,
            .has_same_bytes = records_.have_same_bytes(left, right)};
  }

  const ShapeStore& store_;
  const DuplicateSearch& search_;
  RowRecords& records_;
  const SurfaceGroups& surfaces_;
  double threshold_;
};

}  // namespace

DuplicateReport find_duplicates(const ShapeStore& store, const DuplicateOptions& options) {
  DuplicateReport report;
  const DuplicateSearch search(store, options.filter, report.completed);
  report.compared = search.size();
  RowRecords records(store, search);
  SurfaceGroups surfaces(search, records, options);
  RowGroups groups = join_by_signatures(search, options.threshold);
  if (options.compare_surfaces) groups = surfaces.judge(groups);
  report.measured = surfaces.measured();
  report.not_measured = surfaces.not_measured();
  const GroupDescriber describer(store, search, records, surfaces, options.threshold);
  for (std::vector<std::size_t>& rows : groups) {
    if (rows.size() < 2) continue;
    records.order(rows);
    if (rows.size() > 1) report.groups.push_back(describer.describe(rows));
  }
  std::ranges::sort(report.groups, {}, [](const DuplicateGroup& group) -> const std::string& {
    return group.models.front().path;
  });
  return report;
}

}  // namespace mdbd
