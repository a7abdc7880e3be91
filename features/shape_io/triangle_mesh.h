#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// Three indices into TriangleMesh::vertices, counter-clockwise seen from outside the solid.
using Triangle = std::array<std::uint32_t, 3>;

/// A triangle soup with shared vertices. Nothing is promised about manifoldness, closedness or
/// orientation. Object units; all coordinates are finite and all indices valid.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
};

}  // namespace mdbd
