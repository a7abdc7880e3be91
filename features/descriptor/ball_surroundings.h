#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "features/core/ball.h"
#include "features/descriptor/soft_bins.h"

/// What each ball lies in: the end or the middle of a rod, a plate, a lump.
namespace mdbd {

/// By which radius the reach of surroundings is measured.
enum class ReachUnit {
  own_radius,      ///< of the ball in the middle
  largest_radius,  ///< of the shape
  shape_size       ///< the solid's root mean square distance from its centroid
};

/// What is told of surroundings beside their proportions.
enum class SurroundingsTrait {
  offset,  ///< how far their centroid lies from the ball, relative to the reach
  fill     ///< binary logarithm of the share of their volume that is solid
};

/// The surroundings of a ball out to some reach, and what is told of them.
struct Surroundings {
  std::string_view name;
  double reach = 1.0;  ///< in `unit`
  ReachUnit unit = ReachUnit::own_radius;
  SurroundingsTrait trait = SurroundingsTrait::offset;
};

inline constexpr std::array<Surroundings, 4> surroundings_kinds{
    {{"near", 6.0, ReachUnit::own_radius, SurroundingsTrait::fill},
     {"bulk", 2.0, ReachUnit::largest_radius, SurroundingsTrait::fill},
     {"wide", 3.0, ReachUnit::largest_radius, SurroundingsTrait::offset},
     {"whole", 1.0, ReachUnit::shape_size, SurroundingsTrait::offset}}};

/// The nodes for each of the two proportions and for the trait.
inline constexpr std::size_t surroundings_nodes = 4;
inline constexpr std::size_t surroundings_size =
    surroundings_nodes * surroundings_nodes * surroundings_nodes;

/// The nodes of e2 / e1 and of e3 / e2 …
inline constexpr SoftBins proportion_nodes{0.0, 1.0, surroundings_nodes};
/// … and those of a trait.
constexpr SoftBins trait_nodes(SurroundingsTrait trait) {
  switch (trait) {
    case SurroundingsTrait::offset:
      return {0.0, 0.4, surroundings_nodes};
    case SurroundingsTrait::fill:
      return {-4.0, 1.0, surroundings_nodes};
  }
  return {};
}

/// The shares of the nodes of one kind of surroundings.
using SurroundingsShares = std::array<double, surroundings_size>;

/// How the surroundings of the balls are distributed, for each of the kinds. The surroundings of a
/// ball are the balls whose centres lie within the reach h, each with the weight
/// (1 - d^2 / h^2)^2 r^3 at the distance d. The second moments of their solid about their own
/// centroid have the principal extents e1 >= e2 >= e3 (root mean squares): e2 / e1 and e3 / e2
/// tell rods, plates and lumps apart (after the dimensionality features of point clouds: Demantke,
/// Mallet, David, Vallet, Dimensionality Based Scale Selection in 3D Lidar Point Clouds, 2011).
/// Each ball counts with the weight r^2, its surface. Where the reach is measured by radii, it does
/// not matter how long or how numerous the parts of the shape are as long as they look alike.
/// Continuous in the balls; no rotation or reflection changes it.
/// @param balls in the frame of to_solid_frame(), at least one
/// @returns for each of surroundings_kinds at [(i * surroundings_nodes + j) * surroundings_nodes +
///          k] the share of node i of e2 / e1, from 0 to 1, node j of e3 / e2, from 0 to 1, and
///          node k of the trait: offset from 0 to 0.4, fill from -4 to 1, what lies beyond counted
///          at the ends; the shares of a kind sum to 1
std::array<SurroundingsShares, surroundings_kinds.size()> ball_surroundings(
    std::span<const Ball> balls);

}  // namespace mdbd
