#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "features/shape_io/point_cloud.h"

namespace mdbd {

/// A cloud whose points tell inside from outside.
struct OrientedCloud {
  std::vector<Eigen::Vector3d> points;
  /// For each point the area of the surface that it stands for times its outward normal. Object
  /// units squared.
  std::vector<Eigen::Vector3d> area_vectors;
  double spacing = 0.0;  ///< how far neighbouring samples are apart, see CloudSurface; object units
  /// Where the normals' signs come from: "given normals", "given normals, turned" (they pointed
  /// inward as a whole) or "flood from outside".
  std::string orientation;
  std::size_t outliers = 0;  ///< points left out, see find_outliers()
};

/// The fewest points of a cloud.
inline constexpr std::size_t fewest_points = 50;

/// Orients a cloud without its outliers: estimate_surface(), then the signs of the normals given,
/// or else those of orient_normals(). Normals given are turned where most of them contradict the
/// flood, and are not used where they contradict each other.
/// @pre no two points are equal
/// @throws InvalidInput if there are fewer points than fewest_points, or as orient_normals()
OrientedCloud orient_cloud(const PointCloud& cloud);

}  // namespace mdbd
