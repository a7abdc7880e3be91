#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// A mesh file in a form that OpenMesh reads right: examined, complete, and free of everything but
/// vertices and faces.
///
/// OpenMesh's readers trust what a file says. They reserve whatever is claimed, go on after the end
/// of the file, take colours for faces, open the files that an OBJ names and print to the standard
/// streams. So each format has a function that examines the bytes and writes them anew.
struct PlainFile {
  std::string extension;  ///< names OpenMesh's reader: "off", "ply" or "stl"
  bool is_binary = false;
  std::string bytes;
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  /// The vertices in double precision, which OpenMesh's readers do not keep; empty if the format
  /// has no more than single precision.
  std::vector<Eigen::Vector3d> coordinates;
};

/// What stands for an index outside the vertex list.
inline constexpr std::uint32_t invalid_index = 0xffffffff;

/// Each turns a file of its format into a plain one.
/// @throws InvalidInput with the reason if the content is damaged, truncated, absurd or without
/// faces
PlainFile plain_off(std::string_view bytes);
PlainFile plain_obj(std::string_view bytes);  ///< becomes an OFF file
PlainFile plain_ply(std::string_view bytes);  ///< becomes a binary PLY file
PlainFile plain_stl(std::string_view bytes);  ///< becomes a binary STL file

/// Writes a plain OFF file.
class PlainOffWriter {
 public:
  /// @throws InvalidInput as require_usable
  void add_vertex(const Eigen::Vector3d& vertex);
  void add_face(std::span<const std::uint32_t> corners);
  std::uint64_t vertices() const { return coordinates_.size(); }
  std::uint64_t faces() const { return faces_; }
  /// @throws InvalidInput if there are no faces
  PlainFile finish();

 private:
  std::vector<Eigen::Vector3d> coordinates_;
  std::string vertex_lines_;
  std::string face_lines_;
  std::uint64_t faces_ = 0;
};

/// @param number of the vertex in the file, counted from 0
/// @throws InvalidInput if a coordinate is not finite or beyond 1e30
void require_usable(const Eigen::Vector3d& vertex, std::uint64_t number);

/// @throws InvalidInput if there are no faces
void require_faces(std::uint64_t vertices, std::uint64_t faces);

/// Checks a claimed number of vertices or faces against the size of the file.
/// @param what in the plural
/// @throws InvalidInput if `count` things of at least `least_bytes` each do not fit
void require_room(std::uint64_t count, std::uint64_t least_bytes, std::string_view what,
                  std::uint64_t file_size);

/// An index as a file gives it, counted from 0.
inline std::uint32_t to_index(std::int64_t index) {
  return index >= 0 && index < invalid_index ? static_cast<std::uint32_t>(index) : invalid_index;
}

}  // namespace mdbd
