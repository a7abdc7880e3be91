#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Which faces of a mesh continue each other across their edges. Half-edge 3 f + i runs from corner
/// i of face f to corner (i + 1) % 3.
class FaceNeighbours {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  /// What is done with the faces of an edge that has more than two.
  enum class Junctions {
    open,  ///< none of them is joined
    /// Of the faces left the two that bend the least are joined, as long as there are two. Not at
    /// edges of more than 64 faces.
    flattest
  };

  /// @pre no triangle has the same corner twice
  FaceNeighbours(const TriangleMesh& mesh, Junctions junctions);

  /// The half-edge of the face that continues across this one, or `none`.
  std::uint32_t across(std::uint32_t half_edge) const { return partner_[half_edge]; }

  std::size_t half_edge_count() const { return partner_.size(); }

  /// Separates faces that run along their common edge in the same direction, so that one of them
  /// has its front where the other has its back.
  void cut_conflicts(const TriangleMesh& mesh);

 private:
  void join(const TriangleMesh& mesh, std::vector<std::uint32_t> half_edges);

  std::vector<std::uint32_t> partner_;
};

/// The patches of a mesh, sets of faces that are joined across edges, and how to orient each alike.
struct FacePatches {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> patch_of;  ///< for each face
  /// For each face, whether it runs against the larger area of its patch.
  std::vector<char> is_turned;
};

FacePatches find_patches(const TriangleMesh& mesh, const FaceNeighbours& neighbours);

/// Turns a face around; its first corner stays.
inline void turn(Triangle& triangle) { std::swap(triangle[1], triangle[2]); }

}  // namespace mdbd
