#include "features/shape_io/read_point_cloud.h"

#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/shape_io/shape_files.h"
#include "tests/support/cloud_writers.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;
using Catch::Contains;

namespace {

PointCloudFile read_content(const std::string& extension, const std::string& content) {
  const TemporaryDirectory directory;
  return read_point_cloud(directory.write("cloud" + extension, content));
}

std::string reason_against(const std::string& extension, const std::string& content) {
  try {
    read_content(extension, content);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

/// Some points with normals; all numbers are exact in single precision.
PointCloud example() {
  return {.points = {{0, 0, 0}, {1.5, -2, 0.25}, {-3, 4, 1024}},
          .normals = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}};
}

std::vector<std::pair<std::string, std::string>> samples() {
  const PointCloud cloud = example();
  return {{".pcd", to_pcd(cloud, PcdEncoding::text)},
          {".pcd", to_pcd(cloud, PcdEncoding::binary)},
          {".pcd", to_pcd(cloud, PcdEncoding::compressed)},
          {".ply", to_ply(cloud)},
          {".xyz", to_table(cloud, " ")},
          {".txt", to_table(cloud, "\t")},
          {".csv", "x,y,z,nx,ny,nz\n" + to_table(cloud, ",")},
          {".csv", to_table(cloud, "; ")}};
}

}  // namespace

TEST_CASE("Every format of clouds gives points and normals back, in order") {
  for (const auto& [extension, content] : samples()) {
    INFO(extension << "\n" << content);
    const PointCloudFile file = read_content(extension, content);
    CHECK("." + file.format == extension);
    CHECK(file.cloud.points == example().points);
    CHECK(file.cloud.normals == example().normals);
    CHECK(file.points_not_finite == 0);
    CHECK(file.points_duplicate == 0);
  }
}

TEST_CASE("Clouds without normals have none") {
  const PointCloud bare{.points = example().points, .normals = {}};
  CHECK(read_content(".pcd", to_pcd(bare, PcdEncoding::binary)).cloud.normals.empty());
  CHECK(read_content(".ply", to_ply(bare)).cloud.normals.empty());
  CHECK(read_content(".xyz", to_table(bare, " ")).cloud.normals.empty());
  // Colours are no normals, and one point without a direction takes them from all.
  CHECK(read_content(".xyz", "0 0 0 255 0 0\n1 0 0 0 128 0\n").cloud.normals.empty());
  CHECK(read_content(".csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,0\n1,0,0,0,2,0\n").cloud.normals.empty());
}

TEST_CASE("Tables are read as people write them") {
  const std::vector<Eigen::Vector3d> points = {{1, 2, 3}, {4, 5, 6}};
  for (const std::string content :
       {"# a comment\n1 2 3\n\n4 5 6", "// a comment\r\n1 2 3\r\n4 5 6\r\n", "2\n1 2 3\n4 5 6\n",
        "\xEF\xBB\xBF"
        "1,2,3\n4,5,6\n",
        "1;2;3\n4;5;6\n", " 1   2\t3 \n\t4 5 6 7\n", "X Y Z\n1 2 3\n4 5 6\n",
        "\"z\",\"intensity\",\"y\",\"x\"\n3,,2,1\n6,,5,4\n", "1e0 2.0E+0 3 0.5\n4 5 6 0.25\n"}) {
    INFO(content);
    CHECK(read_content(".txt", content).cloud.points == points);
  }
  const PointCloudFile named = read_content(".csv", "nz,ny,nx,x,y,z\n2,0,0,1,2,3\n0,0,1,4,5,6\n");
  CHECK(named.cloud.points == points);
  CHECK(named.cloud.normals == std::vector<Eigen::Vector3d>{{0, 0, 1}, {1, 0, 0}});
}

TEST_CASE("Points that are not finite and duplicates are dropped and counted") {
  const PointCloudFile table =
      read_content(".xyz", "0 0 0\nnan 0 0\n1 0 0\n0 0 0\n0 inf 0\n1 0 0\n0 1 0\n");
  CHECK(table.cloud.points == std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(table.points_not_finite == 2);
  CHECK(table.points_duplicate == 2);
  PointCloud cloud = example();
  cloud.points[1].y() = std::numeric_limits<double>::quiet_NaN();
  for (const PcdEncoding encoding :
       {PcdEncoding::text, PcdEncoding::binary, PcdEncoding::compressed}) {
    const PointCloudFile file = read_content(".pcd", to_pcd(cloud, encoding));
    CHECK(file.cloud.points == std::vector{cloud.points[0], cloud.points[2]});
    CHECK(file.cloud.normals == std::vector{cloud.normals[0], cloud.normals[2]});
    CHECK(file.points_not_finite == 1);
  }
}

TEST_CASE("A PCD file may have other fields, an order of rows and doubles") {
  const std::string header =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS _ z rgb y x histogram\nSIZE 1 8 4 4 8 4\n"
      "TYPE U F U F F F\nCOUNT 3 1 1 1 1 2\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
      "POINTS 2\nDATA ascii\n";
  const PointCloudFile file =
      read_content(".pcd", header + "1 2 3 0.1 7 20 30 0 0\n1 2 3 -0.25 7 21 31 0 0\n");
  CHECK(file.cloud.points == std::vector<Eigen::Vector3d>{{30, 20, 0.1}, {31, 21, -0.25}});
}

TEST_CASE("A PLY file is a cloud if it has no faces") {
  const TemporaryDirectory directory;
  CHECK(is_point_cloud_file(directory.write("a.ply", to_ply(example()))));
  CHECK_FALSE(is_point_cloud_file(directory.write("b.ply", to_ply_text(make_cube()))));
  CHECK_FALSE(is_point_cloud_file(directory.write("c.ply", "ply\nformat ascii 1.0\n")));
  CHECK_FALSE(is_point_cloud_file(directory.write("d.off", "")));
  std::string strips = to_ply(example());
  strips.insert(strips.find("end_header"),
                "element tristrips 1\nproperty list int int vertex_indices\n");
  CHECK_FALSE(is_point_cloud_file(directory.write("f.ply", strips + "3 0 1 2\n")));
  CHECK(is_point_cloud_file(directory.write("e.PCD", "")));
  CHECK_THROWS_AS(is_point_cloud_file(directory / "missing.ply"), IoError);
}

TEST_CASE("Only texts of points are shapes among the files of a folder") {
  const TemporaryDirectory directory;
  CHECK(is_shape_file(directory.write("a.txt", "0 0 0\n1 0 0\n")));
  CHECK(is_shape_file(directory.write("b.csv", "x,y,z,red\n0,0,0,255\n")));
  CHECK(is_shape_file(directory.write("c.xyz", "anything")));
  CHECK_FALSE(is_shape_file(directory.write("d.txt", "Read this first.\n")));
  CHECK_FALSE(is_shape_file(directory.write("e.csv", "model,distance\na.off,0.1\n")));
  CHECK_FALSE(is_shape_file(directory.write("f.txt", "1 2\n3 4\n")));
  CHECK_FALSE(is_shape_file(directory.write("g.txt", "")));
  CHECK_FALSE(is_shape_file(directory / "missing.txt"));
  CHECK_FALSE(is_shape_file(directory.write("h.pdf", "0 0 0\n")));
}

TEST_CASE("What is no cloud is refused with the reason") {
  CHECK_THAT(reason_against(".pcd", "This is a letter.\n"), Contains("not a PCD file"));
  CHECK_THAT(reason_against(".pcd", ""), Contains("empty"));
  CHECK_THAT(reason_against(".txt", "This is a letter.\n"), Contains("not a table of points"));
  CHECK_THAT(reason_against(".csv", "x,y,z\n"), Contains("no points"));
  CHECK_THAT(reason_against(".xyz", "0 0 0\n1 two 0\n"), Contains("line 2: 'two' is no number"));
  CHECK_THAT(reason_against(".xyz", "0 0 0\n1 2\n"), Contains("line 2 has 2 columns"));
  CHECK_THAT(reason_against(".xyz", std::string("0 0 0\n\0\0", 8)), Contains("zero bytes"));
  CHECK_THAT(reason_against(".xyz", "nan nan nan\n"), Contains("no point has finite"));
  CHECK_THAT(reason_against(".xyz", "1 1 1\n1 1 1\n"), Contains("all points coincide"));
  CHECK_THAT(reason_against(".xyz", "0 0 0\n1e31 0 0\n"), Contains("beyond 1e30"));
  CHECK_THAT(reason_against(".ply", to_ply(PointCloud())), Contains("no points"));
  CHECK_THAT(reason_against(".obj", ""), Contains("does not end in"));
}

TEST_CASE("A PCD header that lies is refused before PCL sees it") {
  const std::string fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  const auto against = [](const std::string& header, const std::string& body) {
    return reason_against(".pcd", "VERSION 0.7\n" + header + body);
  };
  const std::string binary = "DATA binary\n";
  const std::string points(24, '\1');
  CHECK_THAT(against(fields + "WIDTH 2000000000\nHEIGHT 1\nPOINTS 2000000000\n" + binary, points),
             Contains("claims 2000000000 points"));
  CHECK_THAT(against(fields + "WIDTH 3\nHEIGHT 1\nPOINTS 2\n" + binary, points),
             Contains("other numbers of points"));
  CHECK_THAT(against(fields + "WIDTH 2147483647\nHEIGHT 2147483647\n" + binary, points),
             Contains("numbers of points"));
  CHECK_THAT(against(fields + "WIDTH 4\nHEIGHT 1\nPOINTS 4\n" + binary, points),
             Contains("truncated: the file ends after 2 of 4 points"));
  CHECK_THAT(against(fields + "WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n", "0 0 0\n1 0\n"),
             Contains("point 1"));
  CHECK_THAT(against(fields + "WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n", "0 0 0\n0.1 0.2 0.3"),
             Catch::Equals(""));
  CHECK_THAT(
      against("FIELDS x y\nSIZE 4 4\nTYPE F F\nCOUNT 1 1\nWIDTH 3\nHEIGHT 1\n" + binary, points),
      Contains("no fields x, y and z"));
  CHECK_THAT(against("FIELDS x y z\nSIZE 4 4 4\nTYPE I F F\nWIDTH 2\nHEIGHT 1\n" + binary, points),
             Contains("no floating-point numbers"));
  CHECK_THAT(against("FIELDS x y z\nSIZE 4 3 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\n" + binary, points),
             Contains("unknown size"));
  const std::string compressed = fields + "WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA binary_compressed\n";
  CHECK_THAT(against(compressed, "abc"), Contains("truncated"));
  CHECK_THAT(against(compressed, std::string("\xff\0\0\0\x18\0\0\0abcd", 12)),
             Contains("less compressed data"));
  CHECK_THAT(against(compressed, std::string("\4\0\0\0\xff\xff\0\0abcd", 12)),
             Contains("not of the size"));
}

TEST_CASE("Whatever is done to a cloud's file, reading ends with a reason or a sound cloud") {
  const TemporaryDirectory directory;
  std::mt19937 random(1);
  const auto try_to_read = [&](const std::string& extension, const std::string& content) {
    try {
      const PointCloudFile file = read_point_cloud(directory.write("cloud" + extension, content));
      bool is_sound = !file.cloud.points.empty();
      for (const Eigen::Vector3d& point : file.cloud.points) is_sound &= point.allFinite();
      is_sound &=
          !file.cloud.has_normals() || file.cloud.normals.size() == file.cloud.points.size();
      if (!is_sound) FAIL("a cloud that is not sound from a damaged " + extension);
    } catch (const InvalidInput& error) {
      if (std::string_view(error.what()).empty()) FAIL("no reason");
    }
  };
  for (const auto& [extension, content] : samples()) {
    for (std::size_t size = 0; size < content.size(); ++size) {
      try_to_read(extension, content.substr(0, size));
    }
    for (int trial = 0; trial < 400; ++trial) {
      std::string damaged = content;
      const int changes = 1 + static_cast<int>(random() % 3);
      for (int change = 0; change < changes; ++change) {
        damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
      }
      if (trial % 4 == 0) damaged.insert(random() % damaged.size(), "9999999999");
      try_to_read(extension, damaged);
    }
  }
}
