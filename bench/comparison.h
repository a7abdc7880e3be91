#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "bench/ball_quality.h"
#include "features/decomposition/decompose.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd::bench {

/// What is compared on each model; the rivals differ in the resolution of their grids.
inline constexpr std::array<std::string_view, 3> method_names = {"mdbd", "rival 128", "rival 256"};
inline constexpr std::size_t method_count = method_names.size();

/// What one method did with one model.
struct MethodRun {
  double seconds = 0.0;  ///< of processor time, without reading and without the field
  std::uint64_t queries = 0;
  std::uint64_t cells = 0;        ///< octree cells, or voxels of the grid
  std::uint64_t peak_memory = 0;  ///< bytes beyond mesh and field
  BallQuality quality;            ///< beside the balls of the first method
};

/// All methods on one model, one after the other.
struct ModelComparison {
  std::string name;
  std::size_t triangles = 0;
  double field_seconds = 0.0;  ///< processor time for building the field, which all methods use
  std::array<MethodRun, method_count> runs;
};

/// Runs all methods on a closed mesh that faces outward.
/// @throws InvalidInput as MeshDistanceField and decompose()
ModelComparison compare_methods(const std::string& name, const TriangleMesh& mesh,
                                const DecompositionOptions& options);

}  // namespace mdbd::bench
