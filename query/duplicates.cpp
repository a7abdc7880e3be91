#include "query/duplicates.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "features/brep/solid_path.h"
#include "query/collect_vectors.h"
#include "query/exact_search.h"

namespace mdbd {
namespace {

/// Rows that are joined, directly or through others (union-find).
class Partition {
 public:
  explicit Partition(std::size_t size) : parents_(size) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  void join(std::size_t left, std::size_t right) { parents_[root(left)] = root(right); }

  std::size_t root(std::size_t row) {
    while (parents_[row] != row) row = parents_[row] = parents_[parents_[row]];
    return row;
  }

 private:
  std::vector<std::size_t> parents_;
};

/// The vectors of a collection by both signatures.
class Collection {
 public:
  Collection(const ShapeStore& store, const CollectionFilter& filter, std::size_t& completed)
      : radii_metric_(similarity_metric(store.recipe().descriptor_balls, 0.0)) {
    std::size_t none = 0;
    descriptors_ = collect_vectors(store, SignatureKind::mdbd_100, filter, {}, none);
    std::unordered_map<std::int64_t, std::size_t> rows;
    for (std::size_t row = 0; row < descriptors_.size(); ++row) {
      rows[descriptors_[row].shape_id] = row;
    }
    // Another process may have added a model between the two readings.
    VectorTableBuilder fused;
    const VectorTable all =
        collect_vectors(store, SignatureKind::mdbd_fused, filter, {}, completed);
    for (const StoredVector vector : all) {
      const auto row = rows.find(vector.shape_id);
      if (row == rows.end()) continue;
      fused.append(vector);
      descriptor_rows_.push_back(row->second);
    }
    search_.emplace(fused.take(), fused_metric(), descriptor_rows_.size());
  }

  const VectorTable& vectors() const { return search_->collection(); }

  double distance(std::size_t left, std::size_t right) const {
    return fused_->distance(vectors().values(left), vectors().values(right));
  }

  double radii_distance(std::size_t left, std::size_t right) const {
    return radii_metric_->distance(descriptors_.values(descriptor_rows_[left]),
                                   descriptors_.values(descriptor_rows_[right]));
  }

  bool are_duplicates(std::size_t left, std::size_t right, double threshold) const {
    return distance(left, right) <= threshold &&
           radii_distance(left, right) <= radii_share * threshold;
  }

  /// The rows within a distance of a row by mdbd-fused, itself among them, nearest first.
  std::vector<Match> within(std::size_t row, double threshold) const {
    const SearchOptions options{.count = std::numeric_limits<std::size_t>::max(),
                                .threshold = threshold};
    return search_->search(vectors().values(row), options).matches;
  }

  /// The rows that are duplicates of a row.
  std::vector<std::size_t> duplicates_of(std::size_t row, double threshold) const {
    std::vector<std::size_t> rows;
    for (const Match& match : within(row, threshold)) {
      if (radii_distance(row, match.row) <= radii_share * threshold) rows.push_back(match.row);
    }
    return rows;
  }

 private:
  std::unique_ptr<const SignatureMetric> radii_metric_;
  std::unique_ptr<const SignatureMetric> fused_ = fused_metric();
  VectorTable descriptors_;                   // mdbd-100
  std::vector<std::size_t> descriptor_rows_;  // of the rows of vectors()
  std::optional<ExactSearch> search_;
};

/// A model with what it is compared by.
struct Member {
  std::size_t row = 0;
  ShapeRecord record;
  std::vector<float> chirality;
};

/// The row whose group a row joins although neither is a duplicate of the other: the nearest, if
/// those of other groups are much further.
std::optional<std::size_t> clear_neighbour(const Collection& collection,
                                           const std::vector<std::size_t>& groups, std::size_t row,
                                           double threshold) {
  const double limit = cloud_allowance * threshold;
  std::optional<Match> nearest;
  for (const Match& match : collection.within(row, limit / cloud_lead)) {
    if (match.row == row) continue;
    if (!nearest) {
      nearest = match;
    } else if (groups[match.row] != groups[nearest->row]) {
      if (nearest->distance > cloud_lead * match.distance) return std::nullopt;
      break;
    }
  }
  const bool is_near = nearest && nearest->distance <= limit &&
                       collection.radii_distance(row, nearest->row) <= cloud_radii_share * limit;
  return is_near ? std::optional(nearest->row) : std::nullopt;
}

/// Joins clouds that are alone; what each joins does not depend on their order.
void join_clouds(const ShapeStore& store, const Collection& collection, double threshold,
                 Partition& partition) {
  const std::size_t size = collection.vectors().size();
  std::vector<std::size_t> groups(size);
  std::vector<std::size_t> members(size, 0);
  for (std::size_t row = 0; row < size; ++row) ++members[groups[row] = partition.root(row)];
  for (std::size_t row = 0; row < size; ++row) {
    if (members[groups[row]] > 1) continue;
    const std::optional<ShapeRecord> record = store.find(collection.vectors()[row].shape_id);
    if (!record || record->representation != "point cloud") continue;
    const auto neighbour = clear_neighbour(collection, groups, row, threshold);
    if (neighbour) partition.join(row, *neighbour);
  }
}

/// The rows of the collection in groups of two and more.
std::vector<std::vector<std::size_t>> group_rows(const ShapeStore& store,
                                                 const Collection& collection, double threshold) {
  const std::size_t size = collection.vectors().size();
  Partition partition(size);
  for (std::size_t row = 0; row < size; ++row) {
    for (const std::size_t other : collection.duplicates_of(row, threshold)) {
      partition.join(row, other);
    }
  }
  join_clouds(store, collection, threshold, partition);
  std::map<std::size_t, std::vector<std::size_t>> groups;
  for (std::size_t row = 0; row < size; ++row) groups[partition.root(row)].push_back(row);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [root, rows] : groups) {
    if (rows.size() > 1) result.push_back(std::move(rows));
  }
  return result;
}

/// Reads the models of a group, the one to keep first. One that was removed meanwhile is left out.
std::vector<Member> read_members(const ShapeStore& store, const Collection& collection,
                                 const std::vector<std::size_t>& rows) {
  std::vector<Member> members;
  for (const std::size_t row : rows) {
    const std::int64_t id = collection.vectors()[row].shape_id;
    std::optional<ShapeRecord> record = store.find(id);
    if (!record || record->status == ShapeStatus::failed) continue;
    members.push_back({.row = row,
                       .record = std::move(*record),
                       .chirality = compute_chirality(store.data(id).balls)});
  }
  const auto age = [](const Member& member) {
    const ShapeRecord& record = member.record;
    return std::tuple(record.modified_ns, record.path.size(), record.path);
  };
  std::ranges::sort(members, {}, [](const Member& member) { return member.record.path; });
  if (members.empty()) return members;
  const auto keeper = std::ranges::min_element(members, {}, age);
  std::rotate(members.begin(), keeper, keeper + 1);
  return members;
}

/// Solids of files with the same content are the same if their numbers are.
bool has_same_bytes(const ShapeRecord& left, const ShapeRecord& right) {
  return !left.content_hash.empty() && left.content_hash == right.content_hash &&
         split_solid_path(left.path).solid == split_solid_path(right.path).solid;
}

DuplicatePair compare(const Collection& collection, const std::vector<Member>& members,
                      std::size_t first, std::size_t second) {
  const Member& left = members[first];
  const Member& right = members[second];
  return {.first = first,
          .second = second,
          .distance = collection.distance(left.row, right.row),
          .radii_distance = collection.radii_distance(left.row, right.row),
          .scale_ratio = right.record.scale / left.record.scale,
          .hand = compare_hands(left.chirality, right.chirality),
          .has_same_bytes = has_same_bytes(left.record, right.record)};
}

DuplicateGroup describe_group(const Collection& collection, std::vector<Member> members,
                              double threshold) {
  DuplicateGroup group;
  for (std::size_t first = 0; first < members.size(); ++first) {
    for (std::size_t second = first + 1; second < members.size(); ++second) {
      const bool is_pair = first == 0 || collection.are_duplicates(members[first].row,
                                                                   members[second].row, threshold);
      if (is_pair) group.pairs.push_back(compare(collection, members, first, second));
    }
  }
  for (Member& member : members) group.models.push_back(std::move(member.record));
  return group;
}

}  // namespace

DuplicateReport find_duplicates(const ShapeStore& store, const DuplicateOptions& options) {
  DuplicateReport report;
  const Collection collection(store, options.filter, report.completed);
  report.compared = collection.vectors().size();
  for (const std::vector<std::size_t>& rows : group_rows(store, collection, options.threshold)) {
    std::vector<Member> members = read_members(store, collection, rows);
    if (members.size() < 2) continue;
    report.groups.push_back(describe_group(collection, std::move(members), options.threshold));
  }
  std::ranges::sort(report.groups, {}, [](const DuplicateGroup& group) -> const std::string& {
    return group.models.front().path;
  });
  return report;
}

}  // namespace mdbd
