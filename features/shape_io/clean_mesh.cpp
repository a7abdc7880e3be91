#include "features/shape_io/clean_mesh.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>
#include <xxhash.h>

#include "features/core/errors.h"
#include "features/shape_io/triangulate_polygon.h"

namespace mdbd {
namespace {

// Below this sine of the angle at a corner, rounding alone decides what area a triangle has.
constexpr double flat = 4 * std::numeric_limits<double>::epsilon();

constexpr std::uint32_t unused = 0xffffffff;

struct HashBytes {
  std::size_t operator()(const std::array<double, 3>& point) const {
    return XXH3_64bits(point.data(), sizeof point);
  }
};

struct WeldedVertices {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::uint32_t> index_of;  // for each vertex before welding
};

WeldedVertices weld(const std::vector<Eigen::Vector3d>& vertices) {
  WeldedVertices welded;
  welded.index_of.reserve(vertices.size());
  std::unordered_map<std::array<double, 3>, std::uint32_t, HashBytes> index_at;
  index_at.reserve(vertices.size());
  for (const Eigen::Vector3d& vertex : vertices) {
    // Adding zero turns -0.0 into 0.0, so that equal numbers have equal bytes.
    const std::array<double, 3> key = {vertex.x() + 0.0, vertex.y() + 0.0, vertex.z() + 0.0};
    const auto next = static_cast<std::uint32_t>(welded.vertices.size());
    const auto [entry, is_new] = index_at.emplace(key, next);
    if (is_new) welded.vertices.emplace_back(key[0], key[1], key[2]);
    welded.index_of.push_back(entry->second);
  }
  return welded;
}

bool has_area(const std::vector<Eigen::Vector3d>& vertices, const Triangle& triangle) {
  Eigen::Vector3d first = vertices[triangle[1]] - vertices[triangle[0]];
  Eigen::Vector3d second = vertices[triangle[2]] - vertices[triangle[0]];
  const double scale = std::max(first.cwiseAbs().maxCoeff(), second.cwiseAbs().maxCoeff());
  if (scale == 0.0) return false;
  first /= scale;
  second /= scale;
  return first.cross(second).norm() > flat * first.norm() * second.norm();
}

/// Collects the triangles of the faces that are sound, be they flat.
class FaceCollector {
 public:
  explicit FaceCollector(const WeldedVertices& welded) : welded_(welded) {}

  void add(std::span<const std::uint32_t> face) {
    const auto is_bad = [&](std::uint32_t index) { return index >= welded_.index_of.size(); };
    if (std::ranges::any_of(face, is_bad)) {
      ++invalid_;
      return;
    }
    if (face.size() > 3) ++polygons_;
    take_corners(face);
    candidates_.clear();
    if (corners_.size() >= 3) {
      triangulator_.triangulate(welded_.vertices, corners_, candidates_);
    } else {
      ++degenerate_;
    }
    for (const Triangle& triangle : candidates_) {
      const auto [a, b, c] = triangle;
      if (a != b && b != c && c != a) {
        triangles_.push_back(triangle);
      } else {
        ++degenerate_;
      }
    }
  }

  std::vector<Triangle> take_triangles() { return std::move(triangles_); }

  void write_counts(MeshStatistics& statistics) const {
    statistics.polygons_triangulated = polygons_;
    statistics.faces_degenerate = degenerate_;
    statistics.faces_invalid = invalid_;
  }

 private:
  // The welded corners, without those that repeat the one before.
  void take_corners(std::span<const std::uint32_t> face) {
    corners_.clear();
    for (const std::uint32_t index : face) corners_.push_back(welded_.index_of[index]);
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    while (corners_.size() > 1 && corners_.back() == corners_.front()) corners_.pop_back();
  }

  const WeldedVertices& welded_;
  PolygonTriangulator triangulator_;
  std::vector<std::uint32_t> corners_;
  std::vector<Triangle> candidates_;
  std::vector<Triangle> triangles_;
  std::uint64_t polygons_ = 0;
  std::uint64_t degenerate_ = 0;
  std::uint64_t invalid_ = 0;
};

// Returns how many there were. The others keep their order.
std::uint64_t drop_unused_vertices(TriangleMesh& mesh) {
  std::vector<std::uint32_t> new_index(mesh.vertices.size(), unused);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) new_index[corner] = 0;
  }
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (new_index[i] == unused) continue;
    mesh.vertices[kept] = mesh.vertices[i];
    new_index[i] = kept++;
  }
  const std::uint64_t dropped = mesh.vertices.size() - kept;
  mesh.vertices.resize(kept);
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = new_index[corner];
  }
  return dropped;
}

}  // namespace

CleanedMesh clean_mesh(const PolygonMesh& polygons) {
  WeldedVertices welded = weld(polygons.vertices);
  FaceCollector collector(welded);
  for (std::size_t i = 0; i < polygons.face_count(); ++i) collector.add(polygons.face(i));
  TriangleMesh mesh = {std::move(welded.vertices), collector.take_triangles()};
  MeshStatistics statistics = measure_statistics(mesh);
  collector.write_counts(statistics);

  statistics.faces_degenerate += polygons.file_faces - polygons.face_count();
  statistics.faces_degenerate += std::erase_if(
      mesh.triangles, [&](const Triangle& triangle) { return !has_area(mesh.vertices, triangle); });
  if (mesh.triangles.empty()) {
    throw InvalidInput("no face can be used: " + std::to_string(statistics.faces_degenerate) +
                       " without area, " + std::to_string(statistics.faces_invalid) +
                       " with an index outside the vertex list");
  }
  statistics.vertices_welded = polygons.file_vertices - mesh.vertices.size();
  statistics.vertices_unused = drop_unused_vertices(mesh);
  statistics.vertices = mesh.vertices.size();
  statistics.faces = mesh.triangles.size();
  return {std::move(mesh), statistics};
}

}  // namespace mdbd
