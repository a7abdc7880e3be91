// In programs: readers that load the module that does the work.
#include "features/modules/module.h"
#include "features/modules/readers.h"

namespace mdbd {

BrepFile read_brep(const std::filesystem::path& path, std::size_t solid) {
  return load_module<CadModule>().read_brep(path, solid);
}

std::size_t count_solids(const std::filesystem::path& path) {
  return load_module<CadModule>().count_solids(path);
}

SceneMesh read_with_assimp(const std::filesystem::path& path, std::string_view extension,
                           const std::string& bytes) {
  return load_module<SceneModule>().read_with_assimp(path, extension, bytes);
}

VoxelGrid read_vti(const std::string& bytes) { return load_module<VoxelModule>().read_vti(bytes); }

IsoSurface find_iso_surface(const VoxelGrid& grid) {
  return load_module<VoxelModule>().find_iso_surface(grid);
}

PointCloud read_pcd(std::string_view bytes) { return load_module<PcdModule>().read_pcd(bytes); }

}  // namespace mdbd
