#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include <Eigen/Core>

#include "features/core/ball.h"
#include "features/core/convex_polygon.h"

namespace mdbd {

/// Which side of the boundary a point is on.
enum class Side : unsigned char { unknown, inside, outside };

/// A point to be measured, with what the caller already knows about it. Object units.
struct DistanceQuery {
  Eigen::Vector3d point;
  Side side = Side::unknown;  ///< if known, the field need not find out
  /// Another point and its signed distance, or less, or zero: where the empty balls around both
  /// points overlap they are on one side. Only if the boundary is closed.
  Eigen::Vector3d neighbour = Eigen::Vector3d::Zero();
  double neighbour_distance = 0.0;
  /// An upper bound of the distance to the boundary: a warm start. It must be true.
  double bound = std::numeric_limits<double>::infinity();
};

/// The side of a query's point, as far as it follows from what the caller knows.
/// @param distance of the point to the boundary
inline Side side_of(const DistanceQuery& query, double distance) {
  if (query.side != Side::unknown || query.neighbour_distance == 0) return query.side;
  // Across the boundary from each other the balls may touch, but for rounding.
  constexpr double least_overlap = 1e-6;
  const double reach = std::abs(query.neighbour_distance) + distance;
  if (reach * (1.0 - least_overlap) <= (query.point - query.neighbour).norm()) return Side::unknown;
  return query.neighbour_distance > 0 ? Side::inside : Side::outside;
}

/// What is known of the flat surroundings of a boundary point. Object units.
struct FlatRegion {
  std::uint32_t number = 0;  ///< the same for all points of a connected flat part of the boundary
  double radius = 0.0;       ///< the plane belongs to the boundary so far around the point; or zero
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of the plane, a unit vector
};

/// What was measured at a point. Object units.
struct DistanceSample {
  double distance = 0.0;  ///< to the boundary, positive inside the solid and negative outside
  Eigen::Vector3d closest = Eigen::Vector3d::Zero();  ///< a closest point of the boundary
  /// A flat piece of the boundary that contains `closest`, if the representation has any; owned by
  /// the field. It says more about the distances nearby than the point alone.
  ConvexPolygon piece = {};
  /// The flat part of the boundary around `closest`, which may reach beyond the piece.
  FlatRegion flat_region = {};
};

/// All that a decomposition knows of a shape: distances. One implementation for each
/// representation.
///
/// The signed distance is 1-Lipschitz if the boundary is closed. Where it has a hole, only the
/// unsigned distance is, and the sign changes across the hole.
class DistanceField {
 public:
  virtual ~DistanceField() = default;

  /// The smallest ball that encloses the boundary; its radius is the scale R. Positive radius.
  virtual Ball enclosing_ball() const = 0;

  /// The centroid of the boundary: where the mass would rest. It tells apart what distances find
  /// equal. A representation that does not know it has the centre of the enclosing ball.
  virtual Eigen::Vector3d centroid() const { return enclosing_ball().center; }

  /// The d of the paper: 3, or 2 for a domain in the plane z = 0. Its balls are discs centred
  /// there, so that it is measured at points of the plane alone, and its closest points are there,
  /// too.
  virtual int dimension() const { return 3; }

  /// Whether the boundary is closed, so that the sign changes at the boundary alone.
  virtual bool is_closed() const = 0;

  /// Measures samples[i] at queries[i]. Thread-safe. The result does not depend on the batch.
  /// @pre queries.size() == samples.size(); all points are finite
  virtual void measure(std::span<const DistanceQuery> queries,
                       std::span<DistanceSample> samples) const = 0;

  /// Measures one point.
  DistanceSample measure(const DistanceQuery& query) const {
    DistanceSample sample;
    measure(std::span(&query, 1), std::span(&sample, 1));
    return sample;
  }
};

}  // namespace mdbd
