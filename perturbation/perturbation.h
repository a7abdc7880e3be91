#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A change of meshes with all its parameters but the seed.
struct Perturbation {
  std::string name;        ///< with the parameters: "noise 0.5 %"
  bool is_random = false;  ///< whether the seed matters
  /// @throws InvalidInput if a parameter is out of its range or the mesh cannot be changed so
  std::function<TriangleMesh(const TriangleMesh&, std::uint64_t seed)> apply;
};

Perturbation noise_perturbation(double percent);  ///< of the enclosing ball's diameter
Perturbation rotation_perturbation();
Perturbation translation_perturbation(double diameters);  ///< of the enclosing ball
Perturbation scale_perturbation(double factor);
Perturbation mirror_perturbation();
Perturbation subdivision_perturbation();
Perturbation decimation_perturbation(double percent);  ///< of the faces that are to remain
Perturbation shuffling_perturbation();

/// Nothing but the way into a file and back: write_mesh() and read_mesh().
/// @param extension one of written_mesh_extensions(): ".stl"
Perturbation export_perturbation(const std::string& extension);

/// Reads a mesh and changes it. The seed of the copy is derived from `seed` and the content of the
/// file, so that it depends neither on its name nor on what lies beside it: whoever perturbs a file
/// with a seed gets the same copy.
/// @throws IoError, InvalidInput as read_mesh() and Perturbation::apply
TriangleMesh perturb_file(const std::filesystem::path& path, const Perturbation& perturbation,
                          std::uint64_t seed);

}  // namespace mdbd
