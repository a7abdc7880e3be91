#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// Faces of any number of corners as a file holds them: repeated vertices, bad indices and all.
/// Coordinates are finite. The corners of all faces follow one another in one array.
struct PolygonMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::uint32_t> corners;  ///< indices into `vertices`, perhaps beyond its end
  std::vector<std::size_t> face_ends;  ///< for each face, where its corners end in `corners`
  std::uint64_t file_vertices = 0;     ///< in the file, before a reader merged duplicates
  std::uint64_t file_faces = 0;        ///< in the file, before a reader dropped degenerate ones

  std::size_t face_count() const { return face_ends.size(); }
  std::span<const std::uint32_t> face(std::size_t index) const {
    const std::size_t begin = index == 0 ? 0 : face_ends[index - 1];
    return std::span(corners).subspan(begin, face_ends[index] - begin);
  }
};

}  // namespace mdbd
