#include <catch2/catch.hpp>

#include "tests/shape_io/reading.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"

namespace mdbd::test {
namespace {

// A tetrahedron with what may vary in a file around it.
std::string tetrahedron(const std::string& header, const std::string& after_vertex = "",
                        const std::string& after_face = "") {
  std::string text = header;
  for (const char* vertex : {"0 0 0", "1 0 0", "0 1 0", "0 0 1"})
    text += vertex + after_vertex + "\n";
  for (const char* face : {"3 0 2 1", "3 0 1 3", "3 1 2 3", "3 0 3 2"})
    text += face + after_face + "\n";
  return text;
}

void check_tetrahedron(const std::string& text) {
  INFO(text);
  const MeshFile file = read_content(".off", text);
  CHECK(file.mesh.vertices.size() == 4);
  CHECK(file.mesh.triangles.size() == 4);
  CHECK(six_volumes(file.mesh) == Approx(1.0));
  CHECK(file.statistics.watertight);
}

}  // namespace

TEST_CASE("OFF headers from the wild") {
  check_tetrahedron(tetrahedron("OFF\n4 4 6\n"));
  check_tetrahedron(tetrahedron("OFF4 4 6\n"));
  check_tetrahedron(tetrahedron("OFF 4 4 6\n"));
  check_tetrahedron(tetrahedron("OFF\n4 4\n"));
  check_tetrahedron(tetrahedron("OFF # made by hand\n# another\n\n4 4 0 # counts\n\n# vertices\n"));
  check_tetrahedron(tetrahedron("\n# first\nOFF\n4 4 0\n"));
  check_tetrahedron(tetrahedron("\xEF\xBB\xBFOFF\n4 4 0\n"));
}

TEST_CASE("OFF colours, normals and texture coordinates are passed over") {
  check_tetrahedron(tetrahedron("COFF\n4 4 0\n", " 255 0 0 255", ""));
  check_tetrahedron(tetrahedron("COFF\n4 4 0\n", " 0.5 0.5 0.5 1", " 0.1 0.2 0.3"));
  check_tetrahedron(tetrahedron("NOFF\n4 4 0\n", " 0 0 1"));
  check_tetrahedron(tetrahedron("STOFF\n4 4 0\n", " 0.5 0.25"));
  check_tetrahedron(tetrahedron("STCNOFF\n4 4 0\n", " 0 0 1 255 0 0 255 0.5 0.25"));
  check_tetrahedron(tetrahedron("OFF\n4 4 0\n", "", " 255 0 0"));
  check_tetrahedron(tetrahedron("OFF\n4 4 0\n", "", "  0.1 0.2 0.3 0.4"));
  check_tetrahedron(tetrahedron("OFF\n4 4 0\n", "", " 7"));
  check_tetrahedron(tetrahedron("OFF\n4 4 0\n", " # vertex", " # face"));
}

TEST_CASE("OFF with any line ends and number forms") {
  std::string text = tetrahedron("OFF\n4 4 0\n", "", " 255 0 0");
  for (const std::string line_end : {"\r\n", "\r", "\n\n"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? line_end : std::string(1, c);
    check_tetrahedron(other);
  }
  check_tetrahedron(text.substr(0, text.size() - 1));  // no end of the last line
  text.replace(text.find("1 0 0\n"), 6, "+1.0e+0 -0 1e-400\n");
  check_tetrahedron(text);
}

TEST_CASE("OFF polygons are triangulated and counted") {
  const MeshFile file = read_content(
      ".off",
      "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
      "4 0 3 2 1 255 0 0\n4 4 5 6 7 255 0 0\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  CHECK(file.statistics.polygons_triangulated == 6);
  CHECK(file.statistics.faces == 12);
  CHECK(file.statistics.watertight);
  CHECK(six_volumes(file.mesh) == Approx(6.0));
}

TEST_CASE("OFF claims are checked against the file") {
  CHECK_THAT(reason_against(".off", "OFF\n4000000000 4000000000 0\n0 0 0\n"),
             Catch::Equals("claims 4000000000 vertices, but the file has only 34 bytes"));
  CHECK_THAT(reason_against(".off", "OFF\n1 4000000000 0\n0 0 0\n"),
             Catch::StartsWith("claims 4000000000 faces, but the file has only"));
  CHECK_THAT(reason_against(".off", "OFF\n99999999999999999999 1 0\n"),
             Catch::Contains("no number of vertices"));
  CHECK_THAT(reason_against(".off", "OFF\n-4 4 0\n"), Catch::Contains("no number of vertices"));
  CHECK_THAT(reason_against(".off", "OFF\n4 x 0\n"), Catch::Contains("no number of faces"));
  CHECK_THAT(reason_against(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"),
             Catch::Contains("face 0 claims 4000000000 corners"));
  CHECK_THAT(reason_against(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"),
             Catch::Contains("face 0 claims -3 corners"));
  CHECK_THAT(reason_against(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 1"),
             Catch::Equals("face 0 claims 3 corners, but the file has only 2 bytes left"));
}

TEST_CASE("Truncated OFF files are refused") {
  const std::string text = to_off(make_cube());
  CHECK_THAT(reason_against(".off", text.substr(0, text.size() - 10)),
             Catch::Equals("truncated: the file ends after 10 of 12 faces"));
  CHECK_THAT(reason_against(".off", text.substr(0, text.find("0 1 1\n") + 4)),
             Catch::Equals("truncated: the file ends after 6 of 8 vertices"));
}

TEST_CASE("What is no OFF file or one without faces says so") {
  CHECK_THAT(reason_against(".off", "hello"), Catch::Contains("not an OFF file"));
  CHECK_THAT(reason_against(".off", to_obj(make_cube())), Catch::Contains("not an OFF file"));
  CHECK_THAT(reason_against(".off", "OFF"), Catch::Contains("no number of vertices"));
  CHECK_THAT(reason_against(".off", "OFF BINARY\n1234"), Catch::Contains("binary OFF"));
  CHECK_THAT(reason_against(".off", "4OFF\n1 1 1\n"), Catch::Contains("not three-dimensional"));
  CHECK_THAT(reason_against(".off", "OFF\n2 0 0\n0 0 0\n1 1 1\n"),
             Catch::Equals("the file has points but no faces"));
  CHECK_THAT(reason_against(".off", "OFF\n0 0 0\n"), Catch::Contains("neither points nor faces"));
  CHECK_THAT(reason_against(".off", "OFF\n3 1 0\n0 0 0\n1 0 q\n0 1 0\n3 0 1 2\n"),
             Catch::Equals("line 4: 'q' is no coordinate"));
  CHECK_THAT(reason_against(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n"),
             Catch::Equals("line 6: '1.5' is no index"));
}

}  // namespace mdbd::test
