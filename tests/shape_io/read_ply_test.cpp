#include <catch2/catch.hpp>

#include "tests/shape_io/reading.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"

namespace mdbd::test {
namespace {

const std::string corner_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
const std::string vertex_element =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string face_element = "element face 4\nproperty list uchar int vertex_indices\n";
const std::string plain_header =
    "ply\nformat ascii 1.0\n" + vertex_element + face_element + "end_header\n";

void check_tetrahedron(const std::string& content) {
  const MeshFile file = read_content(".ply", content);
  CHECK(file.mesh.vertices.size() == 4);
  CHECK(file.mesh.triangles.size() == 4);
  CHECK(six_volumes(file.mesh) == Approx(1.0));
  CHECK(file.statistics.watertight);
}

// A binary file with extra elements and properties of every type around what is read.
std::string crowded_binary(std::endian order) {
  const bool is_little = order == std::endian::little;
  std::string bytes =
      std::string("ply\r\nformat ") + (is_little ? "binary_little_endian" : "binary_big_endian") +
      " 1.0\r\nobj_info from a scanner\r\n"
      "element camera 2\r\nproperty list short double values\r\nproperty char id\r\n"
      "element vertex 4\r\nproperty uchar red\r\nproperty double z\r\n"
      "property short x\r\nproperty list uint ushort neighbours\r\nproperty float y\r\n"
      "element edge 1\r\nproperty int a\r\nproperty int b\r\n"
      "element face 4\r\nproperty float quality\r\n"
      "property list char uint vertex_index\r\nproperty list uchar float texcoord\r\n"
      "element end 1\r\nproperty uint nothing\r\nend_header\r\n";
  for (int i = 0; i < 2; ++i) {
    append_number<std::int16_t>(bytes, i, order);
    for (int k = 0; k < i; ++k) append_number(bytes, 1.5, order);
    bytes += '\7';
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    bytes += '\xff';
    append_number(bytes, i == 3 ? 1.0 : 0.0, order);
    append_number<std::int16_t>(bytes, i == 1 ? 1 : 0, order);
    append_number(bytes, i, order);
    for (std::uint32_t k = 0; k < i; ++k) append_number<std::uint16_t>(bytes, 9, order);
    append_number(bytes, i == 2 ? 1.0F : 0.0F, order);
  }
  for (int k = 0; k < 2; ++k) append_number(bytes, k, order);
  const std::uint32_t corners[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  for (const auto& face : corners) {
    append_number(bytes, 0.25F, order);
    bytes += '\3';
    for (const std::uint32_t corner : face) append_number(bytes, corner, order);
    bytes += '\2';
    for (int k = 0; k < 2; ++k) append_number(bytes, 0.5F, order);
  }
  append_number(bytes, std::uint32_t{0}, order);
  return bytes;
}

}  // namespace

TEST_CASE("PLY with extra elements and properties") {
  check_tetrahedron(crowded_binary(std::endian::little));
  check_tetrahedron(crowded_binary(std::endian::big));
  check_tetrahedron("ply\nformat ascii 1.0\ncomment made by hand\n" + vertex_element +
                    "property uchar red\nproperty list uchar int tags\n" + face_element +
                    "property float area\nelement edge 1\nproperty int a\nend_header\n"
                    "0 0 0 255 0\n1 0 0 255 1 7\n0 1 0 255 2 7 7\n0 0 1 255 0\n"
                    "3 0 2 1 0.5\n3 0 1 3 0.5\n3 1 2 3 0.5\n3 0 3 2 0.5\n5\n");
}

TEST_CASE("PLY with faces first, other names and other line ends") {
  check_tetrahedron("ply\nformat ascii 1.0\n" + face_element + vertex_element + "end_header\n" +
                    faces + corner_points);
  std::string other = plain_header + corner_points + faces;
  other.replace(other.find("vertex_indices"), 14, "vertex_index");
  check_tetrahedron(other);
  std::string crlf;
  for (const char c : other) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  check_tetrahedron(crlf);
}

TEST_CASE("PLY faces with bad indices are dropped and counted") {
  const std::string bad = "3 0 2 1\n3 0 1 4\n3 -1 2 3\n3 0 3 0\n";
  const MeshFile file = read_content(".ply", plain_header + corner_points + bad);
  CHECK(file.statistics.faces == 1);
  CHECK(file.statistics.faces_invalid == 2);
  CHECK(file.statistics.faces_degenerate == 1);
}

TEST_CASE("What is no PLY file or one without faces says so") {
  CHECK_THAT(reason_against(".ply", "This is a letter.\n"), Catch::Contains("not a PLY file"));
  CHECK_THAT(reason_against(".ply", to_off(make_cube())), Catch::Contains("not a PLY file"));
  CHECK_THAT(reason_against(".ply", "plyformat"), Catch::Contains("not a PLY file"));
  CHECK(reason_against(".ply", "ply\nformat ascii 1.0\n" + vertex_element + "end_header\n" +
                                   corner_points) == "the file has points but no faces");
  CHECK(reason_against(".ply", "ply\nformat ascii 1.0\nend_header\n") ==
        "the file has neither points nor faces");
}

TEST_CASE("Damaged PLY headers are refused") {
  const auto reason = [](const std::string& header) {
    return reason_against(".ply", header + corner_points + faces);
  };
  CHECK_THAT(reason("ply\n"), Catch::Contains("no end_header"));
  CHECK_THAT(reason("ply\n" + vertex_element + "end_header\n"), Catch::Contains("no format"));
  CHECK_THAT(reason("ply\nformat morse 1.0\nend_header\n"), Catch::Contains("no format"));
  CHECK_THAT(reason("ply\nformat ascii 1.0\nproperty float x\nend_header\n"),
             Catch::Contains("property of no element"));
  CHECK_THAT(reason("ply\nformat ascii 1.0\nelement vertex many\nend_header\n"),
             Catch::Contains("no number of 'vertex'"));
  CHECK_THAT(reason("ply\nformat ascii 1.0\nelement vertex -1\nend_header\n"),
             Catch::Contains("no number of 'vertex'"));
  CHECK_THAT(reason("ply\nformat ascii 1.0\nelement vertex 4\nproperty quaternion x\nend_header\n"),
             Catch::Contains("unknown type 'quaternion'"));
  CHECK_THAT(reason("ply\nformat ascii 1.0\nelement face 4\nproperty list float int "
                    "vertex_indices\nend_header\n"),
             Catch::Contains("length is not an integer"));
  CHECK_THAT(reason("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float "
                    "y\nend_header\n"),
             Catch::Contains("no x, y and z"));
}

TEST_CASE("PLY claims are checked against the file") {
  std::string header = plain_header;
  header.replace(header.find("vertex 4"), 8, "vertex 4000000000");
  CHECK_THAT(reason_against(".ply", header + corner_points + faces),
             Catch::StartsWith("claims 4000000000 vertices, but the file has only"));
  header = plain_header;
  header.replace(header.find("face 4"), 6, "face 4000000000");
  CHECK_THAT(reason_against(".ply", header + corner_points + faces),
             Catch::StartsWith("claims 4000000000 faces, but the file has only"));
  CHECK_THAT(reason_against(".ply",
                            "ply\nformat ascii 1.0\nelement dust 9000000000000000000\n"
                            "end_header\n"),
             Catch::Contains("neither points nor faces"));
  CHECK_THAT(reason_against(".ply", plain_header + corner_points + "4000000000 0 1 2\n"),
             Catch::StartsWith("truncated"));
  CHECK_THAT(reason_against(".ply", plain_header + corner_points + "-3 0 1 2\n"),
             Catch::Contains("no valid length"));
  CHECK_THAT(reason_against(".ply", plain_header + corner_points + "3 0 1 two\n"),
             Catch::Contains("'two' is no number"));
}

TEST_CASE("Truncated PLY files are refused") {
  for (const std::string& content :
       {to_ply_text(make_cube()), to_ply_binary<float>(make_cube(), std::endian::little)}) {
    CHECK(reason_against(".ply", content.substr(0, content.size() - 8)) ==
          "truncated: the file ends after 11 of 12 of the element 'face'");
  }
}

}  // namespace mdbd::test
