#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd::test {

/// The cube [0, 1]^3: 8 vertices, 12 triangles, outward.
inline TriangleMesh make_cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.vertices.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Adds a cube [0, size]^3 at `origin`, its vertices shared with nothing.
inline void add_cube(TriangleMesh& mesh, const Eigen::Vector3d& origin, double size,
                     bool is_inverted) {
  const TriangleMesh cube = make_cube();
  const auto start = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : cube.vertices) {
    mesh.vertices.push_back(origin + size * vertex);
  }
  for (auto [a, b, c] : cube.triangles) {
    if (is_inverted) std::swap(b, c);
    mesh.triangles.push_back({a + start, b + start, c + start});
  }
}

/// A torus around the z axis with 2 * around * across triangles, outward. Its coordinates are exact
/// in single precision.
inline TriangleMesh make_torus(double major, double minor, std::uint32_t around,
                               std::uint32_t across) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double u = 2 * std::numbers::pi * i / around;
    for (std::uint32_t j = 0; j < across; ++j) {
      const double v = 2 * std::numbers::pi * j / across;
      const double radius = major + minor * std::cos(v);
      const Eigen::Vector3d vertex(radius * std::cos(u), radius * std::sin(u), minor * std::sin(v));
      mesh.vertices.push_back(vertex.cast<float>().cast<double>());
      const std::uint32_t next_i = (i + 1) % around;
      const std::uint32_t next_j = (j + 1) % across;
      const std::uint32_t a = i * across + j;
      const std::uint32_t b = next_i * across + j;
      const std::uint32_t c = next_i * across + next_j;
      const std::uint32_t d = i * across + next_j;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// A sphere around the origin, outward: a cube's sides of `across` squares each, pushed outward.
inline TriangleMesh make_sphere(double radius, std::uint32_t across) {
  TriangleMesh mesh;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1.0 : -1.0;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t i = 0; i <= across; ++i) {
      for (std::uint32_t j = 0; j <= across; ++j) {
        Eigen::Vector3d point;
        point[axis] = sign;
        point[(axis + 1) % 3] = sign * std::tan(std::numbers::pi / 4 * (2.0 * i / across - 1));
        point[(axis + 2) % 3] = std::tan(std::numbers::pi / 4 * (2.0 * j / across - 1));
        mesh.vertices.push_back(radius * point.normalized());
      }
    }
    for (std::uint32_t i = 0; i < across; ++i) {
      for (std::uint32_t j = 0; j < across; ++j) {
        const std::uint32_t a = first + i * (across + 1) + j;
        const std::uint32_t b = a + across + 1;
        mesh.triangles.push_back({a, b, b + 1});
        mesh.triangles.push_back({a, b + 1, a + 1});
      }
    }
  }
  return mesh;
}

/// Six times the signed volume, positive if the triangles face outward.
inline double six_volumes(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
  }
  return sum;
}

}  // namespace mdbd::test
