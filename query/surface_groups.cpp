#include "query/surface_groups.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "features/brep/solid_path.h"
#include "features/core/disjoint_sets.h"

namespace mdbd {
namespace {

constexpr std::size_t most_neighbours = 3;   // groups, of each group
constexpr std::size_t searched_models = 64;  // beside those of the group itself

/// The number of the group of each row.
std::vector<std::size_t> group_numbers(const RowGroups& groups, std::size_t rows) {
  std::vector<std::size_t> numbers(rows);
  for (std::size_t group = 0; group < groups.size(); ++group) {
    for (const std::size_t row : groups[group]) numbers[row] = group;
  }
  return numbers;
}

}  // namespace

const ShapeRecord* RowRecords::find(std::size_t row) {
  const auto [found, is_new] = records_.try_emplace(row);
  if (is_new) {
    found->second = store_.find(search_.id(row));
    if (found->second && found->second->status == ShapeStatus::failed) found->second.reset();
  }
  return found->second ? &*found->second : nullptr;
}

void RowRecords::order(std::vector<std::size_t>& group) {
  std::erase_if(group, [&](std::size_t row) { return find(row) == nullptr; });
  if (group.empty()) return;
  const auto preference = [&](std::size_t row) {
    const ShapeRecord& record = *find(row);
    return std::tuple(record.representation == "point cloud", record.modified_ns,
                      record.path.size(), record.path);
  };
  std::ranges::sort(group, {}, [&](std::size_t row) { return find(row)->path; });
  const auto keeper = std::ranges::min_element(group, {}, preference);
  std::rotate(group.begin(), keeper, keeper + 1);
}

bool RowRecords::have_same_bytes(std::size_t left, std::size_t right) {
  const ShapeRecord& first = *find(left);
  const ShapeRecord& second = *find(right);
  // Solids of files with the same content are the same if their numbers are.
  return !first.content_hash.empty() && first.content_hash == second.content_hash &&
         split_solid_path(first.path).solid == split_solid_path(second.path).solid;
}

RowGroups SurfaceGroups::judge(const RowGroups& groups) { return join(split(groups)); }

std::optional<double> SurfaceGroups::deviation(std::size_t left, std::size_t right) const {
  const auto found = deviations_.find(std::minmax(left, right));
  return found != deviations_.end() ? found->second : std::nullopt;
}

RowGroups SurfaceGroups::split(const RowGroups& groups) {
  RowGroups ordered = groups;
  std::vector<RowPair> pairs;
  for (std::vector<std::size_t>& group : ordered) {
    if (group.size() < 2) continue;
    records_.order(group);
    for (const std::size_t row : group) {
      if (row == group.front() || records_.have_same_bytes(group.front(), row)) continue;
      pairs.push_back(std::minmax(group.front(), row));
    }
  }
  measure(pairs);
  RowGroups result;
  for (const std::vector<std::size_t>& group : ordered) {
    if (group.empty()) continue;
    std::vector<std::size_t> same;
    for (const std::size_t row : group) {
      const std::optional<double> measured = deviation(group.front(), row);
      if (measured && *measured > same_surface_deviation) {
        result.push_back({row});
      } else {
        same.push_back(row);
      }
    }
    result.push_back(std::move(same));
  }
  return result;
}

RowGroups SurfaceGroups::join(const RowGroups& groups) {
  measure(doubtful_pairs(groups));
  std::vector<RowPair> pairs;
  for (const std::vector<std::size_t>& group : groups) {
    for (const std::size_t row : group) pairs.emplace_back(group.front(), row);
  }
  for (const auto& [pair, measured] : deviations_) {
    if (measured && *measured <= same_surface_deviation) pairs.push_back(pair);
  }
  return join_rows(search_.size(), pairs);
}

/// The first models of groups of which the signatures do not tell whether they are of one shape:
/// near each other, with largest balls of about the same size. The nearest ones of each group.
std::vector<SurfaceGroups::RowPair> SurfaceGroups::doubtful_pairs(const RowGroups& groups) const {
  const std::vector<std::size_t> numbers = group_numbers(groups, search_.size());
  std::set<RowPair> pairs;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    const std::size_t row = groups[group].front();
    std::set<std::size_t> neighbours = {group};
    for (const std::size_t match : search_.nearest(row, groups[group].size() + searched_models,
                                                   doubtful_distance * options_.threshold)) {
      if (neighbours.size() > most_neighbours) break;
      if (search_.largest_radius_difference(row, match) > largest_ball_tolerance) continue;
      const std::size_t other = numbers[match];
      if (neighbours.insert(other).second) pairs.insert(std::minmax(row, groups[other].front()));
    }
  }
  return {pairs.begin(), pairs.end()};
}

void SurfaceGroups::measure(const std::vector<RowPair>& pairs) {
  std::vector<RowPair> open;
  std::vector<ModelPair> models;
  for (const RowPair& pair : pairs) {
    if (deviations_.contains(pair)) continue;
    open.push_back(pair);
    models.push_back({search_.id(pair.first), search_.id(pair.second)});
  }
  const std::vector<std::optional<double>> measured = options_.compare_surfaces(models);
  for (std::size_t i = 0; i < open.size(); ++i) {
    deviations_.emplace(open[i], measured[i]);
    if (!measured[i]) ++not_measured_;
  }
}

RowGroups join_rows(std::size_t rows,
                    const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
  DisjointSets sets(rows);
  for (const auto& [first, second] : pairs) {
    sets.join(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second));
  }
  std::map<std::uint32_t, std::size_t> numbers;
  RowGroups groups;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto [number, is_new] =
        numbers.try_emplace(sets.root(static_cast<std::uint32_t>(row)), groups.size());
    if (is_new) groups.emplace_back();
    groups[number->second].push_back(row);
  }
  return groups;
}

}  // namespace mdbd
