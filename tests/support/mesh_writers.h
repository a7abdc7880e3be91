#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

#include "features/shape_io/triangle_mesh.h"

/// Mesh files as strings, for tests that read them or damage them first.
namespace mdbd::test {

inline std::ostringstream text_stream() {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(std::numeric_limits<double>::max_digits10);
  return stream;
}

inline std::string to_off(const TriangleMesh& mesh) {
  std::ostringstream out = text_stream();
  out << "OFF\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n";
  for (const auto& v : mesh.vertices) out << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const auto& [a, b, c] : mesh.triangles) out << "3 " << a << ' ' << b << ' ' << c << '\n';
  return out.str();
}

inline std::string to_obj(const TriangleMesh& mesh) {
  std::ostringstream out = text_stream();
  for (const auto& v : mesh.vertices) out << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const auto& [a, b, c] : mesh.triangles) {
    out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
  return out.str();
}

inline std::string ply_header(const std::string& format, const TriangleMesh& mesh,
                              const std::string& coordinate_type) {
  const std::string property = "property " + coordinate_type + " ";
  return "ply\nformat " + format + " 1.0\ncomment a test\nelement vertex " +
         std::to_string(mesh.vertices.size()) + "\n" + property + "x\n" + property + "y\n" +
         property + "z\nelement face " + std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string to_ply_text(const TriangleMesh& mesh) {
  std::ostringstream out = text_stream();
  out << ply_header("ascii", mesh, "double");
  for (const auto& v : mesh.vertices) out << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const auto& [a, b, c] : mesh.triangles) out << "3 " << a << ' ' << b << ' ' << c << '\n';
  return out.str();
}

/// Appends the bytes of a number.
template <typename Number>
void append_number(std::string& bytes, Number number, std::endian order = std::endian::little) {
  auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
  if (order != std::endian::native) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

/// @tparam Coordinate float or double
template <typename Coordinate>
std::string to_ply_binary(const TriangleMesh& mesh, std::endian order) {
  const bool is_little = order == std::endian::little;
  std::string bytes = ply_header(is_little ? "binary_little_endian" : "binary_big_endian", mesh,
                                 sizeof(Coordinate) == 4 ? "float" : "double");
  for (const auto& vertex : mesh.vertices) {
    for (const double x : vertex) append_number(bytes, static_cast<Coordinate>(x), order);
  }
  for (const Triangle& triangle : mesh.triangles) {
    bytes += '\3';
    for (const std::uint32_t corner : triangle) append_number(bytes, corner, order);
  }
  return bytes;
}

inline std::string to_stl_text(const TriangleMesh& mesh) {
  std::ostringstream out = text_stream();
  out << "solid test\n";
  for (const Triangle& triangle : mesh.triangles) {
    out << " facet normal 0 0 0\n  outer loop\n";
    for (const std::uint32_t corner : triangle) {
      const auto& v = mesh.vertices[corner];
      out << "   vertex " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
    }
    out << "  endloop\n endfacet\n";
  }
  out << "endsolid test\n";
  return out.str();
}

/// @param title the first words of the header of 80 bytes
inline std::string to_stl_binary(const TriangleMesh& mesh, std::string title = "binary") {
  title.resize(80, ' ');
  std::string bytes = title;
  append_number(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& triangle : mesh.triangles) {
    bytes.append(12, '\0');
    for (const std::uint32_t corner : triangle) {
      for (const double x : mesh.vertices[corner]) append_number(bytes, static_cast<float>(x));
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace mdbd::test
