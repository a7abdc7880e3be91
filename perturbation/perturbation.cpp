#include "perturbation/perturbation.h"

#include <system_error>

#include <fmt/format.h>
#include <stdlib.h>

#include "features/core/errors.h"
#include "features/core/random.h"
#include "features/shape_io/content_hash.h"
#include "features/shape_io/read_mesh.h"
#include "features/shape_io/write_mesh.h"
#include "perturbation/decimation.h"
#include "perturbation/noise.h"
#include "perturbation/shuffling.h"
#include "perturbation/similarity_transform.h"
#include "perturbation/subdivision.h"

namespace mdbd {
namespace {

/// A new folder for temporary files; goes with everything in it.
class ScratchFolder {
 public:
  ScratchFolder() : path_((std::filesystem::temp_directory_path() / "mdbd-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) {
      throw IoError("no temporary folder can be created as " + path_);
    }
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const {
    return std::filesystem::path(path_) / name;
  }

 private:
  std::string path_;
};

TriangleMesh export_and_read(const TriangleMesh& mesh, const std::string& extension) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / ("model" + extension);
  write_mesh(file, mesh);
  return read_mesh(file).mesh;
}

}  // namespace

Perturbation noise_perturbation(double percent) {
  return {.name = fmt::format("noise {} %", percent),
          .is_random = true,
          .apply = [percent](const TriangleMesh& mesh, std::uint64_t seed) {
            return displace_vertices(mesh, percent / 100, seed);
          }};
}

Perturbation rotation_perturbation() {
  return {.name = "rotation", .is_random = true, .apply = rotate};
}

Perturbation translation_perturbation(double diameters) {
  return {.name = fmt::format("translation by {} diameters", diameters),
          .is_random = true,
          .apply = [diameters](const TriangleMesh& mesh, std::uint64_t seed) {
            return translate(mesh, diameters, seed);
          }};
}

Perturbation scale_perturbation(double factor) {
  return {
      .name = fmt::format("scale by {}", factor),
      .apply = [factor](const TriangleMesh& mesh, std::uint64_t) { return scale(mesh, factor); }};
}

Perturbation mirror_perturbation() {
  return {.name = "mirror", .is_random = true, .apply = mirror};
}

Perturbation subdivision_perturbation() {
  return {.name = "subdivision",
          .apply = [](const TriangleMesh& mesh, std::uint64_t) { return subdivide(mesh); }};
}

Perturbation decimation_perturbation(double percent) {
  return {.name = fmt::format("decimation to {} %", percent),
          .apply = [percent](const TriangleMesh& mesh, std::uint64_t) {
            return decimate(mesh, percent / 100);
          }};
}

Perturbation shuffling_perturbation() {
  return {.name = "shuffled order", .is_random = true, .apply = shuffle};
}

Perturbation export_perturbation(const std::string& extension) {
  return {.name = "export as " + extension,
          .apply = [extension](const TriangleMesh& mesh, std::uint64_t) {
            return export_and_read(mesh, extension);
          }};
}

TriangleMesh perturb_file(const std::filesystem::path& path, const Perturbation& perturbation,
                          std::uint64_t seed) {
  const std::uint64_t own_seed =
      perturbation.is_random ? derive_seed(seed, content_hash(path)) : seed;
  return perturbation.apply(read_mesh(path).mesh, own_seed);
}

}  // namespace mdbd
