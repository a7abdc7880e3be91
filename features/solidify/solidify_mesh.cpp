#include "features/solidify/solidify_mesh.h"

#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "features/distance/enclosing_ball.h"
#include "features/solidify/enclosure.h"
#include "features/solidify/face_neighbours.h"
#include "features/solidify/thicken_sheet.h"

namespace mdbd {
namespace {

// So deep below one side of a plate, relative to the radius of its largest balls, is the other.
constexpr double plate_thickness = 2.0;

// The volume over the area, measured from a point near the mesh.
double mean_depth(const TriangleMesh& mesh, const Eigen::Vector3d& origin) {
  double volume = 0.0;
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d p = mesh.vertices[a] - origin;
    const Eigen::Vector3d q = mesh.vertices[b] - origin;
    const Eigen::Vector3d r = mesh.vertices[c] - origin;
    volume += p.dot(q.cross(r)) / 6.0;
    area += (q - p).cross(r - p).norm() / 2.0;
  }
  return std::abs(volume) / area;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles) {
    mesh.triangles.push_back({a + offset, b + offset, c + offset});
  }
}

TriangleMesh used_part(const TriangleMesh& mesh, std::vector<Triangle> triangles) {
  constexpr std::uint32_t unused = 0xffffffff;
  std::vector<std::uint32_t> index_of(mesh.vertices.size(), unused);
  TriangleMesh part;
  for (Triangle& triangle : triangles) {
    for (std::uint32_t& corner : triangle) {
      if (index_of[corner] == unused) {
        index_of[corner] = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.push_back(mesh.vertices[corner]);
      }
      corner = index_of[corner];
    }
  }
  part.triangles = std::move(triangles);
  return part;
}

/// What is known of a surface before anything is done to it.
struct Examination {
  double scale = 0.0;  ///< R
  Enclosure enclosure;
};

Examination examine(const TriangleMesh& mesh, bool is_closed, double minimum_radius) {
  Examination result;
  const Ball enclosing = enclosing_ball(mesh.vertices);
  result.scale = enclosing.radius;
  const double depth = plate_thickness * minimum_radius * enclosing.radius;
  // The volume of a plate is its area, both sides, times the radius of its largest balls.
  if (is_closed && mean_depth(mesh, enclosing.center) >= depth) return result;
  result.enclosure = measure_enclosure(mesh, depth);
  return result;
}

TriangleMesh thicken_sheets(const TriangleMesh& mesh, const Examination& examination) {
  const FacePatches patches = find_patches(mesh, {mesh, FaceNeighbours::Junctions::flattest});
  const std::vector<double> shares =
      share_of_parts(examination.enclosure, patches.patch_of, patches.count);
  std::vector<Triangle> solids;
  std::vector<Triangle> sheets;
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const double share = shares[patches.patch_of[face]];
    (share < least_enclosing_share ? sheets : solids).push_back(mesh.triangles[face]);
  }
  TriangleMesh result = used_part(mesh, std::move(solids));
  append(result, thicken_sheet(used_part(mesh, std::move(sheets)),
                               0.5 * sheet_thickness * examination.scale));
  return result;
}

}  // namespace

SolidifiedMesh solidify_mesh(TriangleMesh mesh, bool is_closed, double minimum_radius) {
  const Examination examination = examine(mesh, is_closed, minimum_radius);
  SolidifiedMesh result{.mesh = {}, .enclosing_share = examination.enclosure.share};
  if (result.enclosing_share >= least_enclosing_share) {
    result.mesh = std::move(mesh);
    return result;
  }
  result.mesh = thicken_sheets(mesh, examination);
  result.thickness = sheet_thickness * examination.scale;
  return result;
}

double measure_enclosing_share(const TriangleMesh& mesh, bool is_closed, double minimum_radius) {
  return examine(mesh, is_closed, minimum_radius).enclosure.share;
}

}  // namespace mdbd
