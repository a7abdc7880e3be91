#include "features/shape_io/write_mesh.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/core/random.h"
#include "features/shape_io/read_mesh.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

namespace mdbd::test {
namespace {

/// A torus of numbers that need all digits of double precision.
TriangleMesh make_awkward_torus() {
  TriangleMesh mesh = make_torus(1.0 / 3.0, 0.1, 12, 8);
  Random random(1);
  for (auto& vertex : mesh.vertices) {
    for (double& x : vertex) x = x * (1 + 1e-10 * random.uniform()) + 1e3;
  }
  return mesh;
}

MeshFile write_and_read(const std::string& name, const TriangleMesh& mesh) {
  const TemporaryDirectory directory;
  write_mesh(directory / name, mesh);
  return read_mesh(directory / name);
}

std::string written(const std::string& name, const TriangleMesh& mesh) {
  const TemporaryDirectory directory;
  write_mesh(directory / name, mesh);
  std::ifstream stream(directory / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("OFF, OBJ and PLY keep a mesh to the bit") {
  const TriangleMesh mesh = make_awkward_torus();
  for (const std::string name : {"a.off", "a.obj", "a.ply", "a.OFF", "a.b.Ply"}) {
    INFO(name);
    const MeshFile file = write_and_read(name, mesh);
    CHECK(file.mesh.vertices == mesh.vertices);
    CHECK(file.mesh.triangles == mesh.triangles);
    CHECK(file.statistics.watertight);
  }
}

TEST_CASE("STL keeps a mesh in single precision") {
  const TriangleMesh mesh = make_torus(3, 1, 12, 8);  // its coordinates are of single precision
  const MeshFile file = write_and_read("a.stl", mesh);
  CHECK(file.statistics.watertight);
  CHECK(file.mesh.vertices.size() == mesh.vertices.size());
  CHECK(file.mesh.triangles.size() == mesh.triangles.size());
  CHECK(six_volumes(file.mesh) == Approx(six_volumes(mesh)).epsilon(1e-12));
}

TEST_CASE("the bytes are those of the formats' definitions") {
  const TriangleMesh cube = make_cube();
  CHECK(written("a.off", cube) == to_off(cube));
  CHECK(written("a.obj", cube) == to_obj(cube));
  const std::string stl = written("a.stl", cube);
  CHECK(stl.size() == 84 + 50 * 12);
  std::string normal;
  for (const float x : {0.0F, 0.0F, -1.0F}) append_number(normal, x);
  CHECK(stl.substr(84, 12) == normal);
  const std::string ply = written("a.ply", cube);
  const std::string known = to_ply_binary<double>(cube, std::endian::little);
  const std::string end = "end_header\n";
  CHECK(ply.substr(ply.find(end)) == known.substr(known.find(end)));
}

TEST_CASE("numbers of all sizes are written") {
  TriangleMesh mesh = make_cube();
  mesh.vertices[7] = {1e29, 5e-324, -0.1};
  for (const std::string name : {"a.off", "a.obj", "a.ply"}) {
    const MeshFile file = write_and_read(name, mesh);
    CHECK(file.mesh.vertices == mesh.vertices);
  }
  mesh.vertices[7].x() = 1e39;
  CHECK_THROWS_WITH(write_and_read("a.stl", mesh), Catch::Contains("too large for STL"));
}

TEST_CASE("no face is lost where three or more meet") {
  TriangleMesh mesh = make_cube();
  mesh.vertices.emplace_back(0.5, 0.5, 2);
  mesh.triangles.push_back({0, 3, 8});
  mesh.triangles.push_back({3, 0, 8});
  mesh.triangles.push_back({0, 3, 7});
  for (const std::string name : {"a.off", "a.obj", "a.ply", "a.stl"}) {
    INFO(name);
    CHECK(write_and_read(name, mesh).statistics.faces == 15);
  }
}

TEST_CASE("what cannot be written says so") {
  const TemporaryDirectory directory;
  CHECK_THROWS_AS(write_mesh(directory / "a.docx", make_cube()), InvalidInput);
  CHECK_THROWS_AS(write_mesh(directory / "off", make_cube()), InvalidInput);
  CHECK_THROWS_AS(write_mesh(directory / "none/a.off", make_cube()), IoError);
}

}  // namespace mdbd::test
