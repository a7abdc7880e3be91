#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "features/descriptor/chirality.h"
#include "query/collection_filter.h"
#include "store/shape_store.h"

namespace mdbd {

/// The distance by mdbd-fused up to which signatures take two models for the same shape, if their
/// radii by mdbd-100 are within radii_share of it, too: docs/duplicates.md tells how they were
/// measured.
inline constexpr double duplicate_distance = 0.06;
inline constexpr double radii_share = 1.0 / 6.0;

/// Two models are of one shape if their surfaces, laid upon each other, nowhere deviate by more
/// than same_surface_deviation of R. They are compared up to a distance of so many thresholds, if
/// the largest radii agree to largest_ball_tolerance of R.
inline constexpr double doubtful_distance = 8.0;
inline constexpr double same_surface_deviation = 0.006;
inline constexpr double largest_ball_tolerance = 2.0 * same_surface_deviation;

/// Two models of the store, by their ids.
struct ModelPair {
  std::int64_t first = 0;
  std::int64_t second = 0;
};

/// Lays the surface of the first model of each pair upon that of the second and measures how far
/// they deviate (Alignment::deviation); nothing for a pair for which it cannot be done.
using CompareSurfaces =
    std::function<std::vector<std::optional<double>>(std::span<const ModelPair> pairs)>;

/// What is asked for.
struct DuplicateOptions {
  double threshold = duplicate_distance;  ///< by mdbd-fused; radii_share of it for the radii
  CollectionFilter filter = {};
  CompareSurfaces compare_surfaces = {};  ///< none: signatures alone decide
};

/// Two models of a group, with what speaks for their being one shape.
struct DuplicatePair {
  std::size_t first = 0;  ///< of DuplicateGroup::models
  std::size_t second = 0;
  double distance = 0.0;        ///< by mdbd-fused
  double radii_distance = 0.0;  ///< the part "radii" of the distance by mdbd-100
  /// Of the surfaces by R of the second, if it was measured.
  std::optional<double> deviation = std::nullopt;
  double scale_ratio = 1.0;  ///< R of the second by R of the first
  Hand hand = Hand::none;
  bool has_same_bytes =
      false;  ///< the files have the same content, of which both are the same solid
};

/// Models of one shape.
struct DuplicateGroup {
  /// First the one that is suggested to be kept: no point cloud if there is a surface, then the
  /// file that was changed last the longest ago and, at equal times, the one with the shortest
  /// path. The others are ordered by path.
  std::vector<ShapeRecord> models;
  /// Every pair within the threshold or with surfaces that were compared, and the first model with
  /// each other one; ordered.
  std::vector<DuplicatePair> pairs = {};
};

struct DuplicateReport {
  std::vector<DuplicateGroup> groups;  ///< ordered by the path of the model to keep
  std::size_t compared = 0;            ///< how many models
  std::size_t completed = 0;           ///< see QueryAnswer::completed
  std::size_t measured = 0;            ///< pairs whose surfaces were compared
  std::size_t not_measured = 0;        ///< pairs whose surfaces could not be compared
};

/// Finds the models of a collection that are the same shape, whatever their pose, hand, scale and
/// format. Signatures propose: pairs within a distance by mdbd-fused, which sees where the balls
/// are, and by the radii of mdbd-100, which part the sizes of a series, are found exactly, and
/// models that such pairs join, also through others, make a group. Surfaces decide: models that
/// deviate from the one to keep leave the group, and groups and single models somewhat further
/// apart are joined if their surfaces agree. Every model is in one group at most.
/// @throws StoreError if the collection cannot be read
DuplicateReport find_duplicates(const ShapeStore& store, const DuplicateOptions& options = {});

}  // namespace mdbd
