#include "features/solidify/orient_shells.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "features/distance/triangle_tree.h"
#include "features/distance/winding_number.h"
#include "features/solidify/face_neighbours.h"

namespace mdbd {
namespace {

// Below this, relative to its absolute terms, a volume is that of a sheet folded flat.
constexpr double negligible_volume = 1e-9;

// Patches that end at an edge of more than two faces enclose nothing by themselves.
std::vector<char> find_closed(const FacePatches& patches, const FaceNeighbours& neighbours) {
  std::vector<char> is_closed(patches.count, 1);
  for (std::uint32_t i = 0; i < neighbours.half_edge_count(); ++i) {
    if (neighbours.across(i) == FaceNeighbours::none) is_closed[patches.patch_of[i / 3]] = 0;
  }
  return is_closed;
}

// The patches that enclose a negative volume, measured from the middle of the mesh for the sake of
// rounding.
std::vector<char> find_inverted(const TriangleMesh& mesh, const FacePatches& patches,
                                const std::vector<char>& is_closed) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  const Eigen::Vector3d middle = box.center();
  std::vector<double> volumes(patches.count, 0.0);
  std::vector<double> absolute(patches.count, 0.0);
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const auto& [a, b, c] = mesh.triangles[face];
    const Eigen::Vector3d p = mesh.vertices[a] - middle;
    const Eigen::Vector3d q = mesh.vertices[b] - middle;
    const double term = p.dot(q.cross(mesh.vertices[c] - middle));
    volumes[patches.patch_of[face]] += term;
    absolute[patches.patch_of[face]] += std::abs(term);
  }
  std::vector<char> is_inverted(patches.count, 0);
  for (std::uint32_t patch = 0; patch < patches.count; ++patch) {
    const bool is_negative = volumes[patch] < -negligible_volume * absolute[patch];
    is_inverted[patch] = is_closed[patch] != 0 && is_negative ? 1 : 0;
  }
  return is_inverted;
}

/// The patches that are inverted and do not lie inside the solids, by the middle of their first
/// faces.
std::vector<char> find_turned(const TriangleMesh& mesh, const FacePatches& patches,
                              const std::vector<char>& is_inverted, const WindingNumber& solids) {
  std::vector<char> is_known(patches.count, 0);
  std::vector<char> is_turned(patches.count, 0);
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const std::uint32_t patch = patches.patch_of[face];
    if (is_known[patch] != 0 || is_inverted[patch] == 0) continue;
    is_known[patch] = 1;
    const auto& [a, b, c] = mesh.triangles[face];
    const Eigen::Vector3d middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
    is_turned[patch] = solids(middle) > 0.5 ? 0 : 1;
  }
  return is_turned;
}

void turn_patches(TriangleMesh& mesh, const FacePatches& patches,
                  const std::vector<char>& is_turned) {
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    if (is_turned[patches.patch_of[face]] != 0) turn(mesh.triangles[face]);
  }
}

/// Turns the patches of negative volume that lie in none of the others.
void turn_inverted(TriangleMesh& mesh, const FacePatches& patches,
                   const std::vector<char>& is_inverted) {
  if (std::ranges::find(is_inverted, 1) == is_inverted.end()) return;
  TriangleMesh solids = {mesh.vertices, {}};
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    if (is_inverted[patches.patch_of[face]] == 0) solids.triangles.push_back(mesh.triangles[face]);
  }
  if (solids.triangles.empty()) {
    std::ranges::for_each(mesh.triangles, turn);
    return;
  }
  const TriangleTree tree(solids);
  turn_patches(mesh, patches, find_turned(mesh, patches, is_inverted, WindingNumber(tree)));
}

}  // namespace

std::uint64_t orient_shells(TriangleMesh& mesh) {
  const std::vector<Triangle> before = mesh.triangles;
  const FaceNeighbours neighbours(mesh, FaceNeighbours::Junctions::open);
  const FacePatches patches = find_patches(mesh, neighbours);
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    if (patches.is_turned[face] != 0) turn(mesh.triangles[face]);
  }
  turn_inverted(mesh, patches, find_inverted(mesh, patches, find_closed(patches, neighbours)));
  std::uint64_t turned = 0;
  for (std::size_t face = 0; face < before.size(); ++face) {
    if (mesh.triangles[face] != before[face]) ++turned;
  }
  return turned;
}

}  // namespace mdbd
