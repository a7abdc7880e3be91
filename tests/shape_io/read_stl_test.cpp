#include <algorithm>
#include <cctype>

#include <catch2/catch.hpp>

#include "tests/shape_io/reading.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"

namespace mdbd::test {
namespace {

void check_cube(const std::string& content) {
  const MeshFile file = read_content(".stl", content);
  CHECK(file.mesh.vertices.size() == 8);
  CHECK(file.mesh.triangles.size() == 12);
  CHECK(six_volumes(file.mesh) == Approx(6.0));
  CHECK(file.statistics.watertight);
  CHECK(file.statistics.vertices_welded == 28);
}

std::string to_upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

}  // namespace

TEST_CASE("Binary STL whose header says solid") {
  check_cube(to_stl_binary(make_cube(), "solid cube"));
  check_cube(to_stl_binary(make_cube(), "solid cube\nfacet normal 0 0 0\nouter loop\n"));
  check_cube(to_stl_binary(make_cube(), "solid cube") + "trailing bytes");
}

TEST_CASE("Binary STL with trailing bytes") {
  check_cube(to_stl_binary(make_cube()) + std::string(3, '\0'));
  check_cube(to_stl_binary(make_cube()) + std::string(50, '\x7f'));
}

TEST_CASE("Text STL from the wild") {
  const std::string text = to_stl_text(make_cube());
  check_cube(to_upper(text));
  check_cube(" \n\t " + text);
  check_cube(text.substr(text.find('\n') + 1));  // without the first line
  std::string other = text;
  other.replace(0, 10, "solid router facet vertex outer loop");
  check_cube(other);
  std::string crlf;
  for (const char c : text) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  check_cube(crlf);
  // A normal of no meaning harms nothing.
  other.replace(other.find("normal 0 0 0"), 12, "normal nan -inf 1e99");
  check_cube(other);
}

TEST_CASE("Text STL of several solids") {
  TriangleMesh lower = make_cube();
  TriangleMesh upper = make_cube();
  for (Eigen::Vector3d& vertex : upper.vertices) vertex.z() += 3;
  const MeshFile file = read_content(".stl", to_stl_text(lower) + to_stl_text(upper));
  CHECK(file.statistics.faces == 24);
  CHECK(file.statistics.components == 2);
}

TEST_CASE("STL faces without area are dropped and counted") {
  TriangleMesh mesh = make_cube();
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({5, 5, 5});
  for (const std::string& content : {to_stl_text(mesh), to_stl_binary(mesh)}) {
    const MeshFile file = read_content(".stl", content);
    CHECK(file.statistics.faces == 12);
    CHECK(file.statistics.faces_degenerate == 2);
    CHECK(file.statistics.watertight);
  }
}

TEST_CASE("Truncated STL files are refused") {
  const std::string binary = to_stl_binary(make_cube());
  CHECK(reason_against(".stl", binary.substr(0, 500)) ==
        "truncated: header claims 12 triangles (684 bytes), file has 500 bytes");
  CHECK_THAT(reason_against(".stl", std::string(40, '\0')), Catch::StartsWith("truncated"));
  std::string absurd = binary;
  absurd.replace(80, 4, "\xff\xff\xff\xff");
  CHECK(reason_against(".stl", absurd) ==
        "truncated: header claims 4294967295 triangles (214748364834 bytes), file has 684 bytes");

  const std::string text = to_stl_text(make_cube());
  for (const std::size_t kept : {text.size() / 2, text.size() - 20, text.rfind("endsolid")}) {
    CHECK_THAT(reason_against(".stl", text.substr(0, kept)), Catch::StartsWith("truncated"));
  }
}

TEST_CASE("Damaged text STL says where") {
  const auto reason = [](std::string from, const std::string& to) {
    std::string text = to_stl_text(make_cube());
    text.replace(text.find(from), from.size(), to);
    return reason_against(".stl", text);
  };
  CHECK(reason("vertex 0 0 0", "vertex 0 0 o") == "line 4: 'o' is no coordinate");
  CHECK(reason("   vertex 0 0 0\n", "") == "line 7: a facet has fewer than three corners");
  CHECK(reason("   vertex 0 0 0\n", "vertex 0 0 0\nvertex 1 1 1\n") ==
        "line 7: a facet has more than three corners");
  CHECK(reason(" endfacet\n", "") == "line 8: a facet begins within a facet");
  CHECK(reason(" facet normal", "") == "line 4: a vertex outside of a facet");
}

TEST_CASE("What is no STL file or one without faces says so") {
  CHECK_THAT(reason_against(".stl", "Dear reader,\n" + std::string(200, 'x')),
             Catch::Contains("not an STL file"));
  CHECK_THAT(reason_against(".stl", "solid nothing\nendsolid nothing\n"), Catch::Contains("no"));
  CHECK_THAT(reason_against(".stl", to_stl_binary(TriangleMesh())), Catch::Contains("faces"));
}

}  // namespace mdbd::test
