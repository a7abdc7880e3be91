#include "features/solidify/thicken_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "features/core/disjoint_sets.h"
#include "features/solidify/face_neighbours.h"

namespace mdbd {
namespace {

// No vertex moves farther, relative to half the thickness: a sharp fold would throw a long spike.
constexpr double miter_limit = 2.0;
// Directions in which the normals of a vertex differ by less, relative to the largest eigenvalue,
// are noise.
constexpr double least_spread = 1e-6;

std::vector<Triangle> distinct_faces(const std::vector<Triangle>& triangles) {
  std::set<Triangle> known;
  std::vector<Triangle> distinct;
  for (const Triangle& triangle : triangles) {
    Triangle key = triangle;
    std::ranges::sort(key);
    if (known.insert(key).second) distinct.push_back(triangle);
  }
  return distinct;
}

/// Sets of corners, numbered as half-edges, that stay together: the fans around each vertex.
class Fans {
 public:
  Fans(const TriangleMesh& mesh, const FaceNeighbours& neighbours)
      : corners_(neighbours.half_edge_count()), number_(neighbours.half_edge_count()) {
    for (std::uint32_t i = 0; i < number_.size(); ++i) {
      const std::uint32_t other = neighbours.across(i);
      if (other == FaceNeighbours::none || other < i) continue;
      join(i, end_of(other));
      join(end_of(i), other);
    }
    number_fans(mesh);
  }

  std::uint32_t of_corner(std::uint32_t corner) const { return number_[corner]; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(vertices_.size()); }
  std::uint32_t vertex(std::uint32_t fan) const { return vertices_[fan]; }

  static std::uint32_t end_of(std::uint32_t half_edge) {
    return half_edge - half_edge % 3 + (half_edge % 3 + 1) % 3;
  }

 private:
  // The first corner of a fan stands for it.
  void join(std::uint32_t left, std::uint32_t right) {
    const auto [first, second] = std::minmax({corners_.root(left), corners_.root(right)});
    corners_.join(first, second);
  }

  void number_fans(const TriangleMesh& mesh) {
    for (std::uint32_t i = 0; i < number_.size(); ++i) {
      const std::uint32_t root = corners_.root(i);
      if (root == i) {
        number_[i] = count();
        vertices_.push_back(mesh.triangles[i / 3][i % 3]);
      } else {
        number_[i] = number_[root];
      }
    }
  }

  DisjointSets corners_;
  std::vector<std::uint32_t> number_;    // of the fan, for each corner
  std::vector<std::uint32_t> vertices_;  // for each fan
};

/// The normals around a vertex, weighted by angle: the sums of n nᵀ and of n.
struct NormalSums {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();
};

// The shortest vector d for which n · d is 1 for all normals n, or nearly so.
Eigen::Vector3d solve_offset(const NormalSums& sums) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sums.squares);
  const Eigen::Vector3d& values = solver.eigenvalues();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    if (!(values[i] > least_spread * values[2])) continue;
    const Eigen::Vector3d direction = solver.eigenvectors().col(i);
    offset += direction.dot(sums.normals) / values[i] * direction;
  }
  const double length = offset.norm();
  return length > miter_limit ? Eigen::Vector3d(miter_limit / length * offset) : offset;
}

std::vector<Eigen::Vector3d> find_offsets(const TriangleMesh& mesh, const Fans& fans) {
  std::vector<NormalSums> sums(fans.count());
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    std::array<Eigen::Vector3d, 3> corners;
    for (int i = 0; i < 3; ++i) corners[i] = mesh.vertices[mesh.triangles[face][i]];
    const Eigen::Vector3d normal =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d first = corners[(i + 1) % 3] - corners[i];
      const Eigen::Vector3d second = corners[(i + 2) % 3] - corners[i];
      const double angle = std::atan2(first.cross(second).norm(), first.dot(second));
      NormalSums& sum = sums[fans.of_corner(3 * face + i)];
      sum.squares += angle * normal * normal.transpose();
      sum.normals += angle * normal;
    }
  }
  std::vector<Eigen::Vector3d> offsets;
  for (const NormalSums& sum : sums) offsets.push_back(solve_offset(sum));
  return offsets;
}

// Vertex 2 f is the front of fan f, 2 f + 1 its back.
TriangleMesh build_sides(const TriangleMesh& mesh, const FaceNeighbours& neighbours,
                         const Fans& fans, double half_thickness) {
  const std::vector<Eigen::Vector3d> offsets = find_offsets(mesh, fans);
  TriangleMesh solid;
  for (std::uint32_t fan = 0; fan < fans.count(); ++fan) {
    const Eigen::Vector3d& vertex = mesh.vertices[fans.vertex(fan)];
    solid.vertices.push_back(vertex + half_thickness * offsets[fan]);
    solid.vertices.push_back(vertex - half_thickness * offsets[fan]);
  }
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    const std::uint32_t a = 2 * fans.of_corner(3 * face);
    const std::uint32_t b = 2 * fans.of_corner(3 * face + 1);
    const std::uint32_t c = 2 * fans.of_corner(3 * face + 2);
    solid.triangles.push_back({a, b, c});
    solid.triangles.push_back({a + 1, c + 1, b + 1});
  }
  for (std::uint32_t i = 0; i < neighbours.half_edge_count(); ++i) {
    if (neighbours.across(i) != FaceNeighbours::none) continue;
    const std::uint32_t start = 2 * fans.of_corner(i);
    const std::uint32_t end = 2 * fans.of_corner(Fans::end_of(i));
    solid.triangles.push_back({end, start, start + 1});
    solid.triangles.push_back({end, start + 1, end + 1});
  }
  return solid;
}

}  // namespace

TriangleMesh thicken_sheet(const TriangleMesh& mesh, double half_thickness) {
  TriangleMesh sheet = {mesh.vertices, distinct_faces(mesh.triangles)};
  constexpr auto flattest = FaceNeighbours::Junctions::flattest;
  const FacePatches patches = find_patches(sheet, FaceNeighbours(sheet, flattest));
  for (std::size_t face = 0; face < sheet.triangles.size(); ++face) {
    if (patches.is_turned[face] != 0) turn(sheet.triangles[face]);
  }
  FaceNeighbours neighbours(sheet, flattest);
  neighbours.cut_conflicts(sheet);
  return build_sides(sheet, neighbours, Fans(sheet, neighbours), half_thickness);
}

}  // namespace mdbd
