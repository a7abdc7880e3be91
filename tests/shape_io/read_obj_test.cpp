#include <catch2/catch.hpp>

#include "tests/shape_io/reading.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"

namespace mdbd::test {
namespace {

const std::string corner_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

void check_tetrahedron(const std::string& text) {
  INFO(text);
  const MeshFile file = read_content(".obj", text);
  CHECK(file.mesh.vertices.size() == 4);
  CHECK(file.mesh.triangles.size() == 4);
  CHECK(six_volumes(file.mesh) == Approx(1.0));
  CHECK(file.statistics.watertight);
}

}  // namespace

TEST_CASE("OBJ corners in every notation") {
  check_tetrahedron(corner_points + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  check_tetrahedron(corner_points + "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n");
  check_tetrahedron(corner_points +
                    "vt 0 0\nf 1/1 3/1 2/1\nf 1/1 2/1 4/1\nf 2/1 3/1 4/1\nf 1/ 4/ 3/\n");
  check_tetrahedron(corner_points +
                    "vt 0 0\nvn 0 0 1\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\n"
                    "f 2/-1/-1 3/-1/-1 4/-1/-1\nf -4//-1 -1//-1 -2//-1\n");
}

TEST_CASE("OBJ negative indices count from the vertices so far") {
  check_tetrahedron(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n");
}

TEST_CASE("OBJ lines from the wild") {
  check_tetrahedron(
      "# comment\r\nmtllib /etc/passwd\r\no thing\r\nv 0 0 0 1.0\r\nv 1 0 0 0.5 0.5 0.5\r\n"
      "  v 0 1 0\r\n\tv 0 0 1\r\n\r\ng group\r\nusemtl red paint\r\ns off\r\nl 1 2\r\np 1\r\n"
      "f 1 3 2 # bottom\r\nf 1 2 4\r\nf 2 3 4\r\nf 1 4 3");
  check_tetrahedron(
      "v 0 \\\n0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
      "f 1 3 \\\r\n 2\nf 1 2 4\nf 2 3 4\nf 1\\\n4\\\n3\n");
}

TEST_CASE("OBJ polygons are triangulated, faces before their vertices too") {
  const MeshFile file = read_content(".obj", "f 1 2 3 4\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n");
  CHECK(file.statistics.polygons_triangulated == 1);
  CHECK(file.statistics.faces == 2);
  CHECK(file.statistics.open_edges == 4);
}

TEST_CASE("OBJ faces with bad indices or repeated corners are dropped and counted") {
  const MeshFile file =
      read_content(".obj", corner_points +
                               "f 1 3 2\nf 1 2 5\nf 0 1 2\nf 1 2 -9\nf 99999999999 1 2\n"
                               "f 1 1 2\nf 1 2\nf\nf 2 1 2 1\n");
  CHECK(file.statistics.faces == 1);
  CHECK(file.statistics.faces_invalid == 4);
  CHECK(file.statistics.faces_degenerate == 5);  // the last one as two triangles
  CHECK(file.statistics.vertices == 3);
  CHECK(file.statistics.vertices_unused == 1);
}

TEST_CASE("Damaged OBJ files say where") {
  CHECK(reason_against(".obj", "v 0 0\n") == "line 1: the vertex has fewer than three coordinates");
  CHECK(reason_against(".obj", "v 0 0 0\n# c\nv 1 x 0\n") == "line 3: 'x' is no coordinate");
  CHECK(reason_against(".obj", "v 1 2 0,5\n") == "line 1: '0,5' is no coordinate");
  CHECK(reason_against(".obj", corner_points + "f a b c\n") == "line 5: 'a' is no index");
  CHECK(reason_against(".obj", corner_points) == "the file has points but no faces");
  CHECK(reason_against(".obj", "hello world\n") == "the file has neither points nor faces");
  CHECK_THAT(reason_against(".obj", "f 1 2 3\n"), Catch::Contains("no face can be used"));
}

}  // namespace mdbd::test
