#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "perturbation/decimation.h"
#include "perturbation/subdivision.h"
#include "tests/perturbation/meshes.h"
#include "tests/support/sample_meshes.h"

namespace mdbd::test {

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

/// A right prism over a regular polygon, its caps fans around a corner, its sides cut into rings.
inline TriangleMesh make_prism(std::uint32_t corners, std::uint32_t rings) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= rings; ++i) {
    for (std::uint32_t j = 0; j < corners; ++j) {
      const double angle = 2 * std::numbers::pi * j / corners;
      mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 2.0 * i / rings);
    }
  }
  for (std::uint32_t i = 0; i < rings; ++i) {
    for (std::uint32_t j = 0; j < corners; ++j) {
      const std::uint32_t a = i * corners + j;
      const std::uint32_t b = i * corners + (j + 1) % corners;
      mesh.triangles.push_back({a, b, b + corners});
      mesh.triangles.push_back({a, b + corners, a + corners});
    }
  }
  const std::uint32_t top = rings * corners;
  for (std::uint32_t j = 1; j + 1 < corners; ++j) {
    mesh.triangles.push_back({0, j + 1, j});
    mesh.triangles.push_back({top, top + j, top + j + 1});
  }
  return mesh;
}

inline TriangleMesh make_bumpy_sphere(int levels) {
  TriangleMesh mesh = make_sphere(levels);
  for (Eigen::Vector3d& v : mesh.vertices) {
    v *= 1 + 0.1 * std::sin(5 * v.x() + 1) * std::sin(6 * v.y()) * std::cos(4 * v.z());
  }
  return mesh;
}

inline TriangleMesh subdivided(TriangleMesh mesh, int levels) {
  for (int i = 0; i < levels; ++i) mesh = subdivide(mesh);
  return mesh;
}

/// Shapes fine enough to show noise.
inline std::vector<NamedMesh> fine_meshes() {
  return {{"sphere", make_sphere(5)},
          {"finer sphere", make_sphere(6)},
          {"torus", make_torus(1, 0.4, 120, 50)},
          {"thin torus", make_torus(1, 0.15, 200, 30)},
          {"bumpy sphere", make_bumpy_sphere(5)},
          {"cube", subdivided(make_cube(), 5)},
          {"sheet", make_sheet(60)}};
}

/// Shapes without noise, coarse and fine, smooth and with edges.
inline std::vector<NamedMesh> clean_meshes() {
  std::vector<NamedMesh> meshes = fine_meshes();
  for (int i = 1; i < 5; ++i) meshes.push_back({"sphere " + std::to_string(i), make_sphere(i)});
  for (const std::uint32_t corners : {3U, 6U, 17U, 100U, 1000U}) {
    for (const std::uint32_t rings : {1U, 4U, 40U}) {
      meshes.push_back({"prism " + std::to_string(corners) + " x " + std::to_string(rings),
                        make_prism(corners, rings)});
    }
  }
  meshes.push_back({"plain cube", make_cube()});
  meshes.push_back({"coarse torus", make_torus(1, 0.4, 12, 8)});
  meshes.push_back({"torus of needles", make_torus(1, 0.3, 400, 7)});
  meshes.push_back({"flat box", make_prism(4, 1)});
  meshes.push_back({"decimated sphere", decimate(make_bumpy_sphere(6), 0.1)});
  meshes.push_back({"decimated torus", decimate(make_torus(1, 0.4, 120, 50), 0.1)});
  return meshes;
}

}  // namespace mdbd::test
