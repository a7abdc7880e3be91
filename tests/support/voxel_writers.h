#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "features/voxel/voxel_grid.h"
#include "tests/support/mesh_writers.h"

/// Grids, and files of them as strings.
namespace mdbd::test {

/// A grid of cubic cells over [-extent, extent]^3 with the values of a function.
inline VoxelGrid sample_grid(std::size_t points, double extent,
                             const std::function<double(const Eigen::Vector3d&)>& value) {
  VoxelGrid grid;
  grid.size = {points, points, points};
  const double step = 2 * extent / static_cast<double>(points - 1);
  grid.origin = Eigen::Vector3d::Constant(-extent);
  grid.steps = step * Eigen::Matrix3d::Identity();
  for (std::size_t z = 0; z < points; ++z) {
    for (std::size_t y = 0; y < points; ++y) {
      for (std::size_t x = 0; x < points; ++x) {
        const Eigen::Vector3d index(static_cast<double>(x), static_cast<double>(y),
                                    static_cast<double>(z));
        grid.values.push_back(value(grid.origin + grid.steps * index));
      }
    }
  }
  return grid;
}

/// Positive inside.
inline double ball_distance_at(const Eigen::Vector3d& x) { return 1.0 - x.norm(); }

inline std::string values_as_text(const VoxelGrid& grid) {
  std::ostringstream out = text_stream();
  for (const double value : grid.values) out << value << '\n';
  return out.str();
}

template <typename Type>
std::string values_as_bytes(const VoxelGrid& grid, std::endian order = std::endian::little) {
  std::string bytes;
  for (const double value : grid.values) append_number(bytes, static_cast<Type>(value), order);
  return bytes;
}

inline std::string sizes_of(const VoxelGrid& grid) {
  return std::to_string(grid.size[0]) + " " + std::to_string(grid.size[1]) + " " +
         std::to_string(grid.size[2]);
}

/// Three numbers.
inline std::string as_text(const Eigen::Vector3d& vector, const char* separator = " ") {
  std::ostringstream out = text_stream();
  out << vector.x() << separator << vector.y() << separator << vector.z();
  return out.str();
}

inline std::string nrrd_header(const VoxelGrid& grid, const std::string& type,
                               const std::string& encoding) {
  std::string axes;
  for (int i = 0; i < 3; ++i) axes += " (" + as_text(grid.steps.col(i), ",") + ")";
  return "NRRD0004\n# a test\ntype: " + type + "\ndimension: 3\nsizes: " + sizes_of(grid) +
         "\nspace: left-posterior-superior\nspace directions:" + axes + "\nspace origin: (" +
         as_text(grid.origin, ",") + ")\nencoding: " + encoding + "\nendian: big\nsome key:=word\n";
}

inline std::string to_nrrd_text(const VoxelGrid& grid) {
  return nrrd_header(grid, "double", "ascii") + "\n" + values_as_text(grid);
}

inline std::string to_nrrd_raw(const VoxelGrid& grid) {
  return nrrd_header(grid, "float", "raw") + "\n" + values_as_bytes<float>(grid, std::endian::big);
}

inline std::string metaimage_header(const VoxelGrid& grid, const std::string& type,
                                    const std::string& more, const std::string& file) {
  Eigen::Matrix3d directions = grid.steps;
  directions.colwise().normalize();
  std::string axes;
  for (int i = 0; i < 3; ++i) axes += " " + as_text(directions.col(i));
  return "ObjectType = Image\nNDims = 3\nDimSize = " + sizes_of(grid) + "\nElementType = " + type +
         "\nElementSpacing = " + as_text(grid.steps.colwise().norm()) +
         "\nOffset = " + as_text(grid.origin) + "\nTransformMatrix =" + axes + "\n" + more +
         "ElementDataFile = " + file + "\n";
}

inline std::string to_metaimage(const VoxelGrid& grid) {
  return metaimage_header(grid, "MET_DOUBLE", "BinaryData = True\n", "LOCAL") +
         values_as_bytes<double>(grid);
}

/// Has no directions.
inline std::string to_vtk(const VoxelGrid& grid, bool is_text) {
  return std::string("# vtk DataFile Version 3.0\na test\n") + (is_text ? "ASCII" : "BINARY") +
         "\nDATASET STRUCTURED_POINTS\nDIMENSIONS " + sizes_of(grid) + "\nORIGIN " +
         as_text(grid.origin) + "\nSPACING " + as_text(grid.steps.diagonal()) + "\nPOINT_DATA " +
         std::to_string(grid.values.size()) + "\nSCALARS values double 1\nLOOKUP_TABLE default\n" +
         (is_text ? values_as_text(grid) : values_as_bytes<double>(grid, std::endian::big));
}

inline std::string to_vti(const VoxelGrid& grid) {
  std::string extent;
  for (const std::size_t size : grid.size) extent += " 0 " + std::to_string(size - 1);
  Eigen::Matrix3d directions = grid.steps;
  directions.colwise().normalize();
  std::string axes;  // row after row
  for (int i = 0; i < 3; ++i) axes += " " + as_text(directions.row(i));
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" "
         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<ImageData WholeExtent=\"" +
         extent.substr(1) + "\" Origin=\"" + as_text(grid.origin) + "\" Spacing=\"" +
         as_text(grid.steps.colwise().norm()) + "\" Direction=\"" + axes.substr(1) +
         "\">\n<Piece Extent=\"" + extent.substr(1) +
         "\"><PointData Scalars=\"values\"><DataArray type=\"Float64\" Name=\"values\" "
         "format=\"ascii\">\n" +
         values_as_text(grid) + "</DataArray></PointData></Piece></ImageData></VTKFile>\n";
}

/// A grid in each format, by ending.
inline std::vector<std::pair<std::string, std::string>> voxel_files(const VoxelGrid& grid) {
  return {{".nrrd", to_nrrd_text(grid)}, {".nrrd", to_nrrd_raw(grid)},
          {".mha", to_metaimage(grid)},  {".vtk", to_vtk(grid, true)},
          {".vtk", to_vtk(grid, false)}, {".vti", to_vti(grid)}};
}

}  // namespace mdbd::test
