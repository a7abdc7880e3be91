#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "features/shape_io/polygon_mesh.h"

namespace mdbd {

/// The faces of a scene, as one mesh.
struct SceneMesh {
  PolygonMesh polygons;
  std::string unit;  ///< of length, in the words of the format: "millimeter"; empty if unknown
};

/// Reads a scene through assimp: all meshes of all nodes, each as often as nodes show it and moved
/// as they say (a node that mirrors keeps the outside outside). Lines, points, materials and
/// animations are left aside. Coordinates are those of the file, of single precision in assimp; the
/// unit is told, never applied, and neither is the upward direction.
/// The external buffers of .gltf are read from the folder of the file and below it, nothing else.
/// @param extension ".3mf", ".3ds", ".dae", ".glb" or ".gltf"; no other importer is asked
/// @param bytes the content of the file
/// @throws InvalidInput with the reason if the content is damaged or without faces. What assimp
///         does to hostile content, it does to this process
SceneMesh read_with_assimp(const std::filesystem::path& path, std::string_view extension,
                           const std::string& bytes);

}  // namespace mdbd
