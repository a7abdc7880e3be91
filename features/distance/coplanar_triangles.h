#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A side of a triangle, which runs from one corner to another.
struct TriangleSide {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t triangle;
};

/// The sides of all triangles; those between the same two vertices follow one another, in order of
/// their triangles.
std::vector<TriangleSide> grouped_sides(const TriangleMesh& mesh);

/// Calls visit(span of sides) for each edge, with all sides between its two vertices.
/// @param sides as grouped_sides() returns them
template <typename Visitor>
void for_each_edge(std::span<const TriangleSide> sides, const Visitor& visit) {
  const auto is_same_edge = [](const TriangleSide& a, const TriangleSide& b) {
    return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
  };
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin + 1;
    while (end < sides.size() && is_same_edge(sides[begin], sides[end])) ++end;
    visit(sides.subspan(begin, end - begin));
    begin = end;
  }
}

/// Tells which triangles of a mesh lie in one plane, but for rounding.
class CoplanarityTest {
 public:
  /// How far a corner may lie from a plane, relative to the size of the mesh.
  static constexpr double flatness = 1e-12;

  /// @param mesh must outlive this object
  explicit CoplanarityTest(const TriangleMesh& mesh);

  /// How far a corner may lie from a plane, object units.
  double tolerance() const { return tolerance_; }

  /// Zero for a triangle without area.
  Eigen::Vector3d unit_normal(std::uint32_t triangle) const;

  /// Whether a triangle faces the same way as another and has its corners in the plane of that.
  bool is_in_plane(std::uint32_t triangle, std::uint32_t of) const;

 private:
  const TriangleMesh& mesh_;
  double tolerance_;
};

/// A normal of a triangle, with twice its area as length.
Eigen::Vector3d area_normal(const TriangleMesh& mesh, std::uint32_t triangle);

}  // namespace mdbd
