#include "features/shape_io/read_voxel_grid.h"

#include <catch2/catch.hpp>
#include <zlib.h>

#include "features/core/errors.h"
#include "tests/support/brute_force.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/voxel_writers.h"

namespace mdbd::test {
namespace {

VoxelGrid read_content(const std::string& ending, const std::string& content) {
  const TemporaryDirectory directory;
  return read_voxel_grid(directory.write("grid" + ending, content)).grid;
}

std::string reason_against(const std::string& ending, const std::string& content) {
  try {
    read_content(ending, content);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

/// Different sizes, spacings and values; exact in single precision.
VoxelGrid example() {
  VoxelGrid grid;
  grid.size = {3, 4, 5};
  grid.origin = {1, 2, 3};
  grid.steps = Eigen::Vector3d(0.5, 0.25, 2).asDiagonal();
  for (int i = 0; i < 60; ++i) grid.values.push_back(0.5 * i - 7);
  return grid;
}

std::string compressed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  packed.resize(size);
  return packed;
}

void check_same(const VoxelGrid& grid, const VoxelGrid& expected) {
  CHECK(grid.size == expected.size);
  CHECK(grid.values == expected.values);
  CHECK(grid.origin.isApprox(expected.origin, 1e-12));
  CHECK(grid.steps.isApprox(expected.steps, 1e-12));
}

}  // namespace

TEST_CASE("Every format gives the same grid") {
  for (const auto& [ending, content] : voxel_files(example())) {
    INFO(ending << "\n" << content.substr(0, 600));
    check_same(read_content(ending, content), example());
  }
}

TEST_CASE("Grids may be turned") {
  VoxelGrid grid = example();
  std::mt19937 random(1);
  grid.steps = random_rotation(random).toRotationMatrix() * grid.steps;
  for (const auto& [ending, content] : voxel_files(grid)) {
    INFO(ending);
    if (ending != ".vtk") check_same(read_content(ending, content), grid);
  }
}

TEST_CASE("Values may be of any type, packed, and in a file of their own") {
  VoxelGrid grid = example();
  for (double& value : grid.values) value += 7.5 + 0.5 * value;  // whole numbers, some negative
  for (double& value : grid.values) value = std::round(value);
  check_same(read_content(".nrrd", nrrd_header(grid, "short", "raw") + "\n" +
                                       values_as_bytes<std::int16_t>(grid, std::endian::big)),
             grid);
  check_same(read_content(".nrrd", nrrd_header(grid, "signed char", "raw") + "\n" +
                                       values_as_bytes<std::int8_t>(grid)),
             grid);
  check_same(
      read_content(".nrrd", nrrd_header(grid, "int64", "gzip") + "\n" +
                                compressed(values_as_bytes<std::int64_t>(grid, std::endian::big))),
      grid);
  check_same(
      read_content(".mha", metaimage_header(grid, "MET_INT", "CompressedData = True\n", "LOCAL") +
                               compressed(values_as_bytes<std::int32_t>(grid))),
      grid);

  const TemporaryDirectory directory;
  directory.write("values.raw", values_as_bytes<float>(grid, std::endian::big));
  check_same(read_voxel_grid(directory.write("a.nhdr", nrrd_header(grid, "float", "raw") +
                                                           "data file: values.raw\n\n"))
                 .grid,
             grid);
  check_same(
      read_voxel_grid(
          directory.write("a.mhd", metaimage_header(grid, "MET_FLOAT",
                                                    "ElementByteOrderMSB = True\n", "values.raw")))
          .grid,
      grid);
}

TEST_CASE("Values outside of the folder are not read") {
  const TemporaryDirectory directory;
  const std::string header = nrrd_header(example(), "float", "raw");
  for (const std::string file : {"../values.raw", "/dev/zero", "missing.raw", "."}) {
    INFO(file);
    const auto path = directory.write("a.nhdr", header + "data file: " + file + "\n\n");
    CHECK_THROWS_AS(read_voxel_grid(path), InvalidInput);
  }
}

TEST_CASE("Absurd sizes are refused before anything is allocated") {
  const auto nrrd = [](const std::string& sizes) {
    return "NRRD0004\ntype: double\ndimension: 3\nsizes: " + sizes + "\nencoding: raw\n\n01234567";
  };
  CHECK_THAT(reason_against(".nrrd", nrrd("500 500 500")),
             Catch::Contains("do not fit") || Catch::Contains("125000000"));
  for (const char* sizes : {"100000 100000 100000", "0 1 1", "-1 1 1", "1 1", "a b c",
                            "18446744073709551615 2 2", "99999999999999999999 1 1"}) {
    CHECK_THAT(reason_against(".nrrd", nrrd(sizes)), Catch::Contains("three sizes"));
  }
  CHECK_THAT(reason_against(".nrrd", nrrd("1 1 1 1")), Catch::Contains("more than three sizes"));
  const std::string vti = to_vti(example());
  std::string huge = vti;
  for (std::size_t at = huge.find("0 2 0 3"); at != huge.npos; at = huge.find("0 2 0 3")) {
    huge.replace(at, 7, "0 500 0 500");
  }
  CHECK_FALSE(reason_against(".vti", huge).empty());
  for (std::size_t at = huge.find("0 500"); at != huge.npos; at = huge.find("0 500")) {
    huge.replace(at, 5, "0 2000000000");
  }
  CHECK_THAT(reason_against(".vti", huge), Catch::Contains("three sizes"));
}

TEST_CASE("What is not supported or damaged is refused with a reason") {
  const std::string nrrd = to_nrrd_text(example());
  const auto changed = [&](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != text.npos);
    return text.replace(at, from.size(), to);
  };
  const auto against = [&](const std::string& from, const std::string& to) {
    return reason_against(".nrrd", changed(nrrd, from, to));
  };
  CHECK_THAT(against("NRRD", "JPEG"), Catch::Contains("no NRRD000"));
  CHECK_THAT(against("dimension: 3", "dimension: 4"), Catch::Contains("not 3"));
  CHECK_THAT(against("dimension: 3", "dimensions: 3"), Catch::Contains("has no \"dimension\""));
  CHECK_THAT(against("type: double", "type: block"), Catch::Contains("unknown type 'block'"));
  CHECK_THAT(against("encoding: ascii", "encoding: hex"), Catch::Contains("'hex'"));
  CHECK_THAT(against("(1,2,3)", "(1,2)"), Catch::Contains("origin has not 3 numbers"));
  CHECK_THAT(against("(1,2,3)", "none"), Catch::Contains("no usable number 'none'"));
  CHECK_THAT(against("(0.5,0,0)", "(0,0,0)"), Catch::Contains("do not span space"));
  CHECK_THAT(against("\n-6.5\n", "\nnan\n"), Catch::Contains("not finite"));
  CHECK_THAT(against("\n-6.5\n", "\nx\n"), Catch::Contains("value 1 of the grid is no number"));
  CHECK_THAT(reason_against(".nrrd", nrrd.substr(0, nrrd.size() - 20)),
             Catch::Contains("truncated"));
  CHECK_FALSE(reason_against(".nrrd", to_nrrd_raw(example()).substr(0, 400)).empty());
  CHECK_THAT(
      reason_against(".vtk", changed(to_vtk(example(), true), "STRUCTURED_POINTS", "POLYDATA")),
      Catch::Contains("no grid of STRUCTURED_POINTS but 'POLYDATA'"));
  CHECK_THAT(reason_against(".mha", changed(to_metaimage(example()), "NDims = 3", "NDims = 2")),
             Catch::Contains("not 3"));
  CHECK_THAT(reason_against(".vtk", "# vtk DataFile Version 3.0"),
             Catch::Contains("neither ASCII nor BINARY"));
  CHECK_THAT(reason_against(".nrrd", "NRRD0004"), Catch::Contains("has no \"dimension\""));
  CHECK_THAT(reason_against(".vti", "<VTKFile"), Catch::Contains("VTK finds no grid"));
  for (const auto& [ending, content] : voxel_files(example())) {
    INFO(ending);
    CHECK(reason_against(ending, "") == "the file is empty");
    CHECK_FALSE(reason_against(ending, "no grid").empty());
    CHECK_FALSE(reason_against(ending, content.substr(0, content.size() / 2)).empty());
  }
  CHECK_THROWS_AS(read_voxel_grid("missing.nrrd"), IoError);
}

}  // namespace mdbd::test
