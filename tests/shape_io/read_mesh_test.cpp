#include "features/shape_io/read_mesh.h"

#include <iostream>
#include <locale>
#include <sstream>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "features/core/errors.h"
#include "tests/shape_io/reading.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"

namespace mdbd::test {
namespace {

struct Sample {
  std::string name;
  std::string extension;
  std::string content;
};

std::vector<Sample> all_formats(const TriangleMesh& mesh) {
  return {{"OFF", ".off", to_off(mesh)},
          {"OBJ", ".obj", to_obj(mesh)},
          {"PLY text", ".ply", to_ply_text(mesh)},
          {"PLY little float", ".ply", to_ply_binary<float>(mesh, std::endian::little)},
          {"PLY big float", ".ply", to_ply_binary<float>(mesh, std::endian::big)},
          {"PLY little double", ".ply", to_ply_binary<double>(mesh, std::endian::little)},
          {"PLY big double", ".ply", to_ply_binary<double>(mesh, std::endian::big)},
          {"STL text", ".stl", to_stl_text(mesh)},
          {"STL binary", ".stl", to_stl_binary(mesh)}};
}

// The corners of all triangles in order: the same for a soup and for shared vertices.
std::vector<Eigen::Vector3d> corners_of(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> corners;
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) corners.push_back(mesh.vertices.at(corner));
  }
  return corners;
}

/// Numbers with a decimal comma, as in a German process.
struct CommaNumbers : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST_CASE("Every format gives the same geometry") {
  for (const TriangleMesh& mesh : {make_cube(), make_torus(2.0, 0.5, 24, 12)}) {
    for (const Sample& sample : all_formats(mesh)) {
      INFO(sample.name);
      const MeshFile file = read_content(sample.extension, sample.content);
      CHECK("." + file.format == sample.extension);
      CHECK(corners_of(file.mesh) == corners_of(mesh));
      CHECK(file.statistics.vertices == mesh.vertices.size());
      CHECK(file.mesh.vertices.size() == mesh.vertices.size());
      CHECK(file.statistics.faces == mesh.triangles.size());
      CHECK(file.statistics.watertight);
      CHECK(file.statistics.orientation == Orientation::outward);
      CHECK(file.statistics.components == 1);
      const bool is_soup = sample.extension == ".stl";
      CHECK(file.statistics.vertices_welded ==
            (is_soup ? 3 * mesh.triangles.size() - mesh.vertices.size() : 0));
      CHECK(file.statistics.faces_degenerate == 0);
      CHECK(file.statistics.vertices_unused == 0);
    }
  }
}

TEST_CASE("Double precision survives where the format has it") {
  TriangleMesh mesh = make_cube();
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex = vertex * 0.1 + Eigen::Vector3d(4e6, 5e5, 1.0 / 3.0);
  }
  for (const Sample& sample : all_formats(mesh)) {
    if (sample.extension == ".stl" || sample.name.ends_with("float")) continue;
    INFO(sample.name);
    CHECK(read_content(sample.extension, sample.content).mesh.vertices == mesh.vertices);
  }
}

TEST_CASE("No face is lost at an edge of three faces") {
  // Three fins on the edge 0-1.
  TriangleMesh fins;
  fins.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  fins.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  for (const Sample& sample : all_formats(fins)) {
    INFO(sample.name);
    const MeshFile file = read_content(sample.extension, sample.content);
    CHECK(corners_of(file.mesh) == corners_of(fins));
    CHECK(file.statistics.non_manifold_edges == 1);
    CHECK(file.statistics.open_edges == 6);
    CHECK_FALSE(file.statistics.watertight);
  }
}

TEST_CASE("A mesh that is inverted as a whole is turned outward and named") {
  TriangleMesh inverted = make_torus(2.0, 0.5, 12, 8);
  for (Triangle& triangle : inverted.triangles) std::swap(triangle[0], triangle[1]);
  REQUIRE(six_volumes(inverted) < 0);
  for (const Sample& sample : all_formats(inverted)) {
    INFO(sample.name);
    const MeshFile file = read_content(sample.extension, sample.content);
    CHECK(file.statistics.orientation == Orientation::inverted);
    CHECK(six_volumes(file.mesh) == Approx(-six_volumes(inverted)));
    CHECK(measure_statistics(file.mesh).orientation == Orientation::outward);
  }
}

TEST_CASE("Endings are known in upper and lower case") {
  CHECK(mesh_file_extensions().size() == 9);
  CHECK(has_mesh_extension("a/b.OFF"));
  CHECK(has_mesh_extension("b.Stl"));
  CHECK(has_mesh_extension("b.c.obj"));
  CHECK_FALSE(has_mesh_extension("off"));
  CHECK_FALSE(has_mesh_extension("a.off/b"));
  CHECK_FALSE(has_mesh_extension("b.offx"));
  CHECK_FALSE(has_mesh_extension("b.of"));
  CHECK_FALSE(has_mesh_extension(".off"));
  CHECK(read_content(".OFF", to_off(make_cube())).format == "off");
  CHECK(read_content(".STL", to_stl_binary(make_cube())).format == "stl");
  CHECK_THAT(reason_against(".txt", "OFF"), Catch::Contains("does not end in"));
}

TEST_CASE("Numbers are read whatever the locale of the process") {
  const TriangleMesh mesh = make_torus(2.0, 0.5, 40, 30);
  const std::vector<Sample> samples = all_formats(mesh);
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaNumbers));
  std::vector<MeshFile> files;
  for (const Sample& sample : samples) {
    files.push_back(read_content(sample.extension, sample.content));
  }
  std::locale::global(before);
  for (const MeshFile& file : files) CHECK(corners_of(file.mesh) == corners_of(mesh));
}

TEST_CASE("Several threads read at the same time") {
  const TriangleMesh mesh = make_torus(2.0, 0.5, 20, 10);
  const std::vector<Sample> samples = all_formats(mesh);
  std::vector<char> is_right(2 * samples.size(), 0);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < is_right.size(); ++i) {
    threads.emplace_back([&, i] {
      const Sample& sample = samples[i % samples.size()];
      const MeshFile file = read_content(sample.extension, sample.content);
      is_right[i] = corners_of(file.mesh) == corners_of(mesh) ? 1 : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(std::ranges::count(is_right, 1) == static_cast<long>(is_right.size()));
}

TEST_CASE("Files that cannot be read say why") {
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory / "a.off");
  CHECK_THROWS_WITH(read_mesh(directory / "a.off"), Catch::Contains("is a directory"));
  CHECK_THROWS_AS(read_mesh(directory / "a.off"), IoError);
  CHECK_THROWS_WITH(read_mesh(directory / "missing.off"), Catch::Contains("no such file"));
  CHECK_THROWS_AS(read_mesh(directory / "missing.off"), IoError);

  REQUIRE(mkfifo((directory / "pipe.off").c_str(), 0600) == 0);
  CHECK_THROWS_WITH(read_mesh(directory / "pipe.off"), Catch::Contains("not a regular file"));

  const std::filesystem::path secret = directory.write("secret.off", to_off(make_cube()));
  std::filesystem::permissions(secret, std::filesystem::perms::none);
  if (geteuid() != 0) {  // root reads everything
    CHECK_THROWS_WITH(read_mesh(secret), Catch::Contains("Permission denied"));
    CHECK_THROWS_AS(read_mesh(secret), IoError);
  }
}

TEST_CASE("Empty and blank files say so in every format") {
  for (const std::string_view extension : mesh_file_extensions()) {
    CHECK(reason_against(extension, "") == "the file is empty");
    CHECK_THAT(reason_against(extension, " \n\t\r\n"), Catch::Contains("empty but for blanks"));
  }
}

TEST_CASE("Coordinates that are not finite or absurd are refused in every format") {
  TriangleMesh mesh = make_torus(2.0, 0.5, 6, 4);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    mesh.vertices[12].y() = bad;
    for (const Sample& sample : all_formats(mesh)) {
      INFO(sample.name);
      const std::string reason = reason_against(sample.extension, sample.content);
      CHECK_THAT(reason, Catch::Contains("has a coordinate that is not finite"));
      if (sample.extension != ".stl") CHECK_THAT(reason, Catch::Contains("vertex 12 "));
    }
  }
  mesh.vertices[12].y() = -1e31;
  for (const Sample& sample : all_formats(mesh)) {
    INFO(sample.name);
    CHECK_THAT(reason_against(sample.extension, sample.content), Catch::Contains("beyond 1e30"));
  }
}

TEST_CASE("A model too small to calculate with is refused") {
  TriangleMesh mesh = make_cube();
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= 1e-80;
  CHECK(reason_against(".off", to_off(mesh)).empty());
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= 1e-80;
  CHECK_THAT(reason_against(".off", to_off(mesh)), Catch::Contains("smaller than 1e-90"));
}

TEST_CASE("Nothing is printed") {
  std::ostringstream printed;
  std::streambuf* const out = std::cout.rdbuf(printed.rdbuf());
  std::streambuf* const err = std::cerr.rdbuf(printed.rdbuf());
  std::streambuf* const log = std::clog.rdbuf(printed.rdbuf());
  for (const Sample& sample : all_formats(make_cube())) {
    reason_against(sample.extension, sample.content);
    reason_against(sample.extension, sample.content.substr(0, sample.content.size() / 2));
  }
  reason_against(".obj", "mtllib none.mtl\nusemtl none\nv 0 0\nvt 1\nf 1 2 3\n");
  std::cout.rdbuf(out);
  std::cerr.rdbuf(err);
  std::clog.rdbuf(log);
  CHECK(printed.str().empty());
}

}  // namespace mdbd::test
