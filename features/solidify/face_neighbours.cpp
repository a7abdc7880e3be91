#include "features/solidify/face_neighbours.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

namespace mdbd {
namespace {

// Pairing costs the cube of the number of faces at an edge.
constexpr std::size_t most_at_junction = 64;

std::uint32_t start_of(const TriangleMesh& mesh, std::uint32_t half_edge) {
  return mesh.triangles[half_edge / 3][half_edge % 3];
}

std::uint32_t end_of(const TriangleMesh& mesh, std::uint32_t half_edge) {
  return mesh.triangles[half_edge / 3][(half_edge % 3 + 1) % 3];
}

std::uint32_t apex_of(const TriangleMesh& mesh, std::uint32_t half_edge) {
  return mesh.triangles[half_edge / 3][(half_edge % 3 + 2) % 3];
}

// Where a face goes from an edge: a unit vector in its plane, across the edge.
Eigen::Vector3d direction_from(const TriangleMesh& mesh, std::uint32_t half_edge) {
  const Eigen::Vector3d& start = mesh.vertices[start_of(mesh, half_edge)];
  const Eigen::Vector3d along = (mesh.vertices[end_of(mesh, half_edge)] - start).normalized();
  const Eigen::Vector3d arm = mesh.vertices[apex_of(mesh, half_edge)] - start;
  return (arm - arm.dot(along) * along).normalized();
}

double doubled_area(const TriangleMesh& mesh, const Triangle& triangle) {
  const Eigen::Vector3d& origin = mesh.vertices[triangle[0]];
  return (mesh.vertices[triangle[1]] - origin).cross(mesh.vertices[triangle[2]] - origin).norm();
}

// Faces of one orientation run along their common edge in opposite directions.
bool run_alike(const TriangleMesh& mesh, std::uint32_t half_edge, std::uint32_t other) {
  return start_of(mesh, half_edge) == start_of(mesh, other);
}

/// Visits one patch after the other.
class PatchSearch {
 public:
  PatchSearch(const TriangleMesh& mesh, const FaceNeighbours& neighbours)
      : mesh_(mesh), neighbours_(neighbours) {
    patches_.patch_of.assign(mesh.triangles.size(), FaceNeighbours::none);
    patches_.is_turned.assign(mesh.triangles.size(), 0);
  }

  FacePatches run() {
    for (std::uint32_t face = 0; face < mesh_.triangles.size(); ++face) {
      if (patches_.patch_of[face] == FaceNeighbours::none) spread(face);
    }
    return std::move(patches_);
  }

 private:
  void spread(std::uint32_t seed) {
    std::vector<std::uint32_t> faces = {seed};
    patches_.patch_of[seed] = patches_.count;
    double turned_area = 0.0;
    double area = 0.0;
    for (std::size_t next = 0; next < faces.size(); ++next) {
      const std::uint32_t face = faces[next];
      const double size = doubled_area(mesh_, mesh_.triangles[face]);
      area += size;
      if (patches_.is_turned[face] != 0) turned_area += size;
      for (std::uint32_t side = 0; side < 3; ++side) visit(3 * face + side, faces);
    }
    if (turned_area > 0.5 * area) {
      for (const std::uint32_t face : faces) patches_.is_turned[face] ^= 1;
    }
    ++patches_.count;
  }

  void visit(std::uint32_t half_edge, std::vector<std::uint32_t>& faces) {
    const std::uint32_t other = neighbours_.across(half_edge);
    if (other == FaceNeighbours::none) return;
    if (patches_.patch_of[other / 3] != FaceNeighbours::none) return;
    patches_.patch_of[other / 3] = patches_.count;
    patches_.is_turned[other / 3] =
        patches_.is_turned[half_edge / 3] ^ static_cast<char>(run_alike(mesh_, half_edge, other));
    faces.push_back(other / 3);
  }

  const TriangleMesh& mesh_;
  const FaceNeighbours& neighbours_;
  FacePatches patches_;
};

}  // namespace

FaceNeighbours::FaceNeighbours(const TriangleMesh& mesh, Junctions junctions)
    : partner_(3 * mesh.triangles.size(), none) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> edges;
  edges.reserve(partner_.size());
  for (std::uint32_t i = 0; i < partner_.size(); ++i) {
    const auto [low, high] = std::minmax({start_of(mesh, i), end_of(mesh, i)});
    edges.emplace_back(low, high, i);
  }
  std::ranges::sort(edges);
  std::vector<std::uint32_t> around;
  for (std::size_t begin = 0; begin < edges.size(); begin += around.size()) {
    around.clear();
    const auto [low, high, first] = edges[begin];
    for (std::size_t i = begin; i < edges.size(); ++i) {
      const auto& [other_low, other_high, half_edge] = edges[i];
      if (other_low != low || other_high != high) break;
      around.push_back(half_edge);
    }
    const bool is_joined = junctions == Junctions::flattest && around.size() <= most_at_junction;
    if (around.size() == 2 || is_joined) join(mesh, around);
  }
}

void FaceNeighbours::cut_conflicts(const TriangleMesh& mesh) {
  for (std::uint32_t i = 0; i < partner_.size(); ++i) {
    const std::uint32_t other = partner_[i];
    if (other == none || !run_alike(mesh, i, other)) continue;
    partner_[other] = none;
    partner_[i] = none;
  }
}

void FaceNeighbours::join(const TriangleMesh& mesh, std::vector<std::uint32_t> half_edges) {
  std::vector<Eigen::Vector3d> directions;
  for (const std::uint32_t i : half_edges) directions.push_back(direction_from(mesh, i));
  while (half_edges.size() >= 2) {
    std::pair<std::size_t, std::size_t> best = {0, 1};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; half_edges.size() > 2 && i < half_edges.size(); ++i) {
      for (std::size_t j = i + 1; j < half_edges.size(); ++j) {
        const double cosine = directions[i].dot(directions[j]);
        if (cosine < least) {
          least = cosine;
          best = {i, j};
        }
      }
    }
    partner_[half_edges[best.first]] = half_edges[best.second];
    partner_[half_edges[best.second]] = half_edges[best.first];
    for (const std::size_t gone : {best.second, best.first}) {
      half_edges.erase(half_edges.begin() + static_cast<std::ptrdiff_t>(gone));
      directions.erase(directions.begin() + static_cast<std::ptrdiff_t>(gone));
    }
  }
}

FacePatches find_patches(const TriangleMesh& mesh, const FaceNeighbours& neighbours) {
  return PatchSearch(mesh, neighbours).run();
}

}  // namespace mdbd
