#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// How the faces of a mesh are oriented.
enum class Orientation {
  outward,   ///< neighbours agree and the enclosed volume is positive
  inverted,  ///< neighbours agree and the enclosed volume is negative
  mixed      ///< some neighbours disagree
};

/// What a mesh is like and what reading it dropped: the record of a model. Edges, components and
/// orientation are those of the file's surface with its faces of no area, which may close it.
struct MeshStatistics {
  std::uint64_t vertices = 0;            ///< after welding, used by at least one face
  std::uint64_t faces = 0;               ///< triangles kept
  bool watertight = false;               ///< no open edge: every edge has an even number of faces
  std::uint64_t open_edges = 0;          ///< edges with one face
  std::uint64_t non_manifold_edges = 0;  ///< edges with three faces or more
  std::uint64_t components = 0;          ///< sets of faces connected through shared vertices
  Orientation orientation = Orientation::outward;

  std::uint64_t polygons_triangulated = 0;  ///< faces of four corners or more in the file
  std::uint64_t vertices_welded = 0;        ///< exact duplicates merged into another vertex
  std::uint64_t vertices_unused = 0;        ///< dropped: no face uses them
  std::uint64_t faces_degenerate = 0;  ///< dropped: fewer than three different corners, no area
  std::uint64_t faces_invalid = 0;     ///< dropped: an index outside the vertex list
};

std::string_view to_string(Orientation orientation);

/// Counts what can be seen in a mesh; the counts of what was dropped stay zero.
/// The sign of the volume of an open mesh is that of its shell as seen from the middle of its box.
MeshStatistics measure_statistics(const TriangleMesh& mesh);

/// One flat JSON object with the names of the fields; the orientation as text.
std::string to_json(const MeshStatistics& statistics);

}  // namespace mdbd
