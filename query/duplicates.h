#pragma once

#include <cstddef>
#include <vector>

#include "features/descriptor/chirality.h"
#include "query/collection_filter.h"
#include "store/shape_store.h"

namespace mdbd {

/// The distance by mdbd-fused up to which two models are taken for the same shape, if their radii
/// by mdbd-100 are within radii_share of it, too: docs/duplicates.md tells how they were measured.
inline constexpr double duplicate_distance = 0.06;
inline constexpr double radii_share = 1.0 / 6.0;

/// The balls of a point cloud are known to its spacing only. A cloud that has no duplicate joins
/// the nearest group within so many times the threshold, and within a share of that for the radii,
/// if every other group is far enough: the nearest is at most this part of the next distance.
inline constexpr double cloud_allowance = 2.0;
inline constexpr double cloud_radii_share = 0.3;
inline constexpr double cloud_lead = 0.5;

/// What is asked for.
struct DuplicateOptions {
  double threshold = duplicate_distance;  ///< by mdbd-fused; radii_share of it for the radii
  CollectionFilter filter = {};
};

/// Two models of a group, with what speaks for their being one shape.
struct DuplicatePair {
  std::size_t first = 0;  ///< of DuplicateGroup::models
  std::size_t second = 0;
  double distance = 0.0;        ///< by mdbd-fused
  double radii_distance = 0.0;  ///< the part "radii" of the distance by mdbd-100
  double scale_ratio = 1.0;     ///< R of the second by R of the first
  Hand hand = Hand::none;
  bool has_same_bytes =
      false;  ///< the files have the same content, of which both are the same solid
};

/// Models of one shape.
struct DuplicateGroup {
  /// First the one that is suggested to be kept: the file that was changed last the longest ago
  /// and, at equal times, the one with the shortest path. The others are ordered by path.
  std::vector<ShapeRecord> models;
  /// Every pair within the threshold, and the first model with each other one; ordered.
  std::vector<DuplicatePair> pairs;
};

struct DuplicateReport {
  std::vector<DuplicateGroup> groups;  ///< ordered by the path of the model to keep
  std::size_t compared = 0;            ///< how many models
  std::size_t completed = 0;           ///< see QueryAnswer::completed
};

/// Finds the models of a collection that are the same shape, whatever their pose, hand, scale and
/// format: pairs within a distance by mdbd-fused, which sees where the balls are, and by the radii
/// of mdbd-100, which part the sizes of a series; found exactly. Models that such pairs join, also
/// through others, make a group. A point cloud that is in none joins one by cloud_allowance. Every
/// model is in one group at most.
/// @throws StoreError if the collection cannot be read
DuplicateReport find_duplicates(const ShapeStore& store, const DuplicateOptions& options = {});

}  // namespace mdbd
