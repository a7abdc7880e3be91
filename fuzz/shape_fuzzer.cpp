// Feeds a reader whatever libFuzzer comes up with. It must refuse it with a reason or make finite
// numbers of it. MDBD_READER names one of the functions below.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "features/core/errors.h"
#include "features/implicit/csg_distance_field.h"
#include "features/implicit/read_csg.h"
#include "features/shape_io/assimp_reader.h"
#include "features/shape_io/clean_mesh.h"
#include "features/shape_io/point_formats.h"
#include "features/shape_io/read_planar_domain.h"
#include "features/shape_io/voxel_header.h"
#include "features/shape_io/vti_reader.h"

namespace {

void require(bool is_right) {
  if (!is_right) std::abort();
}

// Points of a file may be anything; what is not finite is dropped later.
void check(const mdbd::PointCloud& cloud) {
  require(cloud.normals.empty() || cloud.normals.size() == cloud.points.size());
}

[[maybe_unused]] void pcd(std::string_view bytes) { check(mdbd::read_pcd(bytes)); }
[[maybe_unused]] void xyz(std::string_view bytes) { check(mdbd::read_point_table(bytes)); }
[[maybe_unused]] void ply_points(std::string_view bytes) { check(mdbd::read_ply_points(bytes)); }

void scene(std::string_view extension, std::string_view bytes) {
  const auto polygons = mdbd::read_with_assimp("model", extension, std::string(bytes)).polygons;
  const mdbd::TriangleMesh mesh = mdbd::clean_mesh(polygons).mesh;
  for (const mdbd::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      require(corner < mesh.vertices.size() && mesh.vertices[corner].allFinite());
    }
  }
}

[[maybe_unused]] void threemf(std::string_view bytes) { scene(".3mf", bytes); }
[[maybe_unused]] void threeds(std::string_view bytes) { scene(".3ds", bytes); }
[[maybe_unused]] void dae(std::string_view bytes) { scene(".dae", bytes); }
[[maybe_unused]] void glb(std::string_view bytes) { scene(".glb", bytes); }
[[maybe_unused]] void gltf(std::string_view bytes) { scene(".gltf", bytes); }

[[maybe_unused]] void csg(std::string_view bytes) {
  const mdbd::CsgSolid solid = mdbd::read_csg(bytes);
  if (solid.size() > 12) return;  // takes its time
  const mdbd::CsgDistanceField field(solid);
  const mdbd::Ball ball = field.enclosing_ball();
  require(std::isfinite(ball.radius) && ball.radius > 0);
  require(std::isfinite(field.measure({.point = ball.center}).distance));
}

void check(const mdbd::VoxelHeader& header) {
  require(header.size[0] * header.size[1] * header.size[2] <= std::uint64_t{1} << 27);
}

[[maybe_unused]] void nrrd(std::string_view bytes) { check(mdbd::read_nrrd_header(bytes)); }
[[maybe_unused]] void mha(std::string_view bytes) { check(mdbd::read_metaimage_header(bytes)); }
[[maybe_unused]] void vtk(std::string_view bytes) { check(mdbd::read_vtk_header(bytes)); }
[[maybe_unused]] void vti(std::string_view bytes) {
  const mdbd::VoxelGrid grid = mdbd::read_vti(std::string(bytes));
  require(grid.values.size() == grid.size[0] * grid.size[1] * grid.size[2]);
}

void check(const mdbd::PlanarDomain& domain) {
  const mdbd::PlanarDomain simple = mdbd::simplify(domain);
  require(std::isfinite(mdbd::area(simple)));
}

[[maybe_unused]] void svg(std::string_view bytes) { check(mdbd::read_svg(std::string(bytes))); }
[[maybe_unused]] void wkt(std::string_view bytes) { check(mdbd::read_wkt(std::string(bytes))); }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    MDBD_READER(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const mdbd::InvalidInput& error) {
    require(!std::string_view(error.what()).empty());
  }
  return 0;
}
