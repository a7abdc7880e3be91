#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace mdbd {

/// What the header of a file of voxels says.
struct VoxelHeader {
  enum class Number { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };
  enum class Encoding { raw, text, compressed };

  std::array<std::uint64_t, 3> size = {0, 0, 0};
  Number number = Number::u8;
  Encoding encoding = Encoding::raw;
  bool is_big_endian = false;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();
  std::string data_file;        ///< beside the file; empty if the data follow the header
  std::size_t data_offset = 0;  ///< in the file that has the data, bytes
};

/// Each reads the header of its format.
/// @throws InvalidInput with the reason if it is damaged, or says what is not supported
VoxelHeader read_nrrd_header(std::string_view bytes);
VoxelHeader read_metaimage_header(std::string_view bytes);
VoxelHeader read_vtk_header(std::string_view bytes);  ///< legacy VTK, structured points

}  // namespace mdbd
