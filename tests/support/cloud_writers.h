#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "features/shape_io/point_cloud.h"

/// Point clouds as files have them.
namespace mdbd::test {

enum class PcdEncoding { text, binary, compressed };

/// The numbers of each point: its coordinates, then its normal if it has one.
inline std::vector<std::vector<double>> point_rows(const PointCloud& cloud) {
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    std::vector<double>& row = rows.emplace_back();
    for (const double x : cloud.points[i]) row.push_back(x);
    if (!cloud.has_normals()) continue;
    for (const double x : cloud.normals[i]) row.push_back(x);
  }
  return rows;
}

inline std::string to_table(const PointCloud& cloud, const std::string& separator) {
  std::ostringstream text;
  text.precision(17);
  for (const std::vector<double>& row : point_rows(cloud)) {
    for (std::size_t i = 0; i < row.size(); ++i) text << (i == 0 ? "" : separator) << row[i];
    text << "\n";
  }
  return text.str();
}

inline std::string to_ply(const PointCloud& cloud) {
  std::string header = "ply\nformat ascii 1.0\nelement vertex " +
                       std::to_string(cloud.points.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\n";
  if (cloud.has_normals()) {
    header += "property double nx\nproperty double ny\nproperty double nz\n";
  }
  return header + "end_header\n" + to_table(cloud, " ");
}

template <typename Number>
void append_raw(std::string& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
  bytes.append(raw.data(), raw.size());
}

/// The fields one after the other, as the compressed encoding has them, in LZF's runs of literals.
inline std::string to_lzf(const std::vector<std::vector<double>>& rows) {
  std::string plain;
  for (std::size_t field = 0; field < rows.front().size(); ++field) {
    for (const auto& row : rows) append_raw(plain, static_cast<float>(row[field]));
  }
  std::string packed;
  for (std::size_t begin = 0; begin < plain.size(); begin += 32) {
    const std::string run = plain.substr(begin, 32);
    packed += static_cast<char>(run.size() - 1);
    packed += run;
  }
  std::string bytes;
  append_raw(bytes, static_cast<std::uint32_t>(packed.size()));
  append_raw(bytes, static_cast<std::uint32_t>(plain.size()));
  return bytes + packed;
}

/// In single precision.
inline std::string to_pcd(const PointCloud& cloud, PcdEncoding encoding) {
  const std::string count = std::to_string(cloud.points.size());
  std::string header = "# .PCD v0.7\nVERSION 0.7\n";
  header += cloud.has_normals() ? "FIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\n"
                                  "TYPE F F F F F F\nCOUNT 1 1 1 1 1 1\n"
                                : "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  header += "WIDTH " + count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA ";
  if (encoding == PcdEncoding::text) return header + "ascii\n" + to_table(cloud, " ");
  if (encoding == PcdEncoding::compressed) {
    return header + "binary_compressed\n" + to_lzf(point_rows(cloud));
  }
  std::string bytes = header + "binary\n";
  for (const auto& row : point_rows(cloud)) {
    for (const double number : row) append_raw(bytes, static_cast<float>(number));
  }
  return bytes;
}

}  // namespace mdbd::test
