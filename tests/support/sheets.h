#pragma once

#include <cstdint>

#include "features/shape_io/triangle_mesh.h"

/// Surfaces that enclose nothing.
namespace mdbd::test {

/// Adds the square of the corners origin, origin + first, origin + first + second, origin + second,
/// its vertices shared with nothing.
inline void add_parallelogram(TriangleMesh& mesh, const Eigen::Vector3d& origin,
                              const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  const auto start = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex :
       {origin, Eigen::Vector3d(origin + first), Eigen::Vector3d(origin + first + second),
        Eigen::Vector3d(origin + second)}) {
    mesh.vertices.push_back(vertex);
  }
  mesh.triangles.push_back({start, start + 1, start + 2});
  mesh.triangles.push_back({start, start + 2, start + 3});
}

/// The square [0, 1]^2 at z = 0.
inline TriangleMesh make_square() {
  TriangleMesh mesh;
  add_parallelogram(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  return mesh;
}

/// Two unit squares that meet in the y axis at a right angle, in one mesh of six vertices.
inline TriangleMesh make_fold() {
  return {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 1, 1}},
          {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}}};
}

/// A table of sheets: a top 2 x 1 and four legs, each two strips at a right angle.
inline TriangleMesh make_sheet_table() {
  TriangleMesh mesh;
  add_parallelogram(mesh, {0, 0, 0}, {2, 0, 0}, {0, 1, 0});
  for (const double x : {0.0, 2.0}) {
    for (const double y : {0.0, 1.0}) {
      add_parallelogram(mesh, {x, y, -1}, {x > 0 ? -0.2 : 0.2, 0, 0}, {0, 0, 1});
      add_parallelogram(mesh, {x, y, -1}, {0, y > 0 ? -0.2 : 0.2, 0}, {0, 0, 1});
    }
  }
  return mesh;
}

}  // namespace mdbd::test
