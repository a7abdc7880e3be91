#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include "features/shape_io/triangle_mesh.h"
#include "perturbation/subdivision.h"
#include "tests/support/sample_meshes.h"

namespace mdbd::test {

/// The unit sphere: an octahedron, cut into 4^levels triangles a face. Outward.
inline TriangleMesh make_sphere(int levels) {
  TriangleMesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int i = 0; i < levels; ++i) mesh = subdivide(mesh);
  for (auto& vertex : mesh.vertices) vertex.normalize();
  return mesh;
}

/// A flat square of 2 n^2 triangles, open all around.
inline TriangleMesh make_sheet(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) mesh.vertices.emplace_back(x, y, 0);
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return mesh;
}

inline double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d& origin = mesh.vertices[a];
    sum += (mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin).norm() / 2;
  }
  return sum;
}

inline bool are_equal(const TriangleMesh& left, const TriangleMesh& right) {
  return left.vertices == right.vertices && left.triangles == right.triangles;
}

}  // namespace mdbd::test
