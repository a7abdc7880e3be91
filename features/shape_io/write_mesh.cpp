#include "features/shape_io/write_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include <Eigen/Geometry>

#include "features/core/errors.h"
#include "features/shape_io/output_file.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

/// Appends a number in the shortest form that reads back to the same bits.
template <typename Number>
void append_text(std::string& text, Number number) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), end);
}

template <typename Number>
void append_bytes(std::string& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
  bytes.append(raw.data(), raw.size());
}

/// Appends lines like "v 0.5 1 0" or "3 0 1 2".
template <typename Row>
void append_line(std::string& text, std::string_view start, const Row& row) {
  std::string_view gap = start;
  for (const auto number : row) {
    text += gap;
    append_text(text, number);
    gap = " ";
  }
  text += '\n';
}

std::string format_off(const TriangleMesh& mesh) {
  std::string text = "OFF\n";
  append_line(text, "", std::array{mesh.vertices.size(), mesh.triangles.size(), std::size_t{0}});
  for (const Eigen::Vector3d& vertex : mesh.vertices) append_line(text, "", vertex);
  for (const Triangle& triangle : mesh.triangles) append_line(text, "3 ", triangle);
  return text;
}

std::string format_obj(const TriangleMesh& mesh) {
  std::string text;
  for (const Eigen::Vector3d& vertex : mesh.vertices) append_line(text, "v ", vertex);
  for (const auto& [a, b, c] : mesh.triangles) {
    append_line(text, "f ", std::array{a + 1, b + 1, c + 1});
  }
  return text;
}

std::string format_ply(const TriangleMesh& mesh) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(mesh.vertices.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    for (const double x : vertex) append_bytes(bytes, x);
  }
  for (const Triangle& triangle : mesh.triangles) {
    bytes += '\3';
    for (const std::uint32_t corner : triangle) append_bytes(bytes, corner);
  }
  return bytes;
}

Eigen::Vector3f to_single(const Eigen::Vector3d& vertex) {
  if (vertex.cwiseAbs().maxCoeff() > std::numeric_limits<float>::max()) {
    throw InvalidInput("a coordinate is too large for STL, which has single precision");
  }
  return vertex.cast<float>();
}

void append_vector(std::string& bytes, const Eigen::Vector3f& vector) {
  for (const float x : vector) append_bytes(bytes, x);
}

std::string format_stl(const TriangleMesh& mesh) {
  std::string bytes = "binary STL";  // "solid" as first word would stand for text
  bytes.resize(80, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d& origin = mesh.vertices[a];
    const Eigen::Vector3d normal =
        (mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin).stableNormalized();
    append_vector(bytes, normal.cast<float>());
    for (const std::uint32_t corner : {a, b, c}) {
      append_vector(bytes, to_single(mesh.vertices[corner]));
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

using Format = std::string (*)(const TriangleMesh&);

// In the order of the functions.
constexpr std::array<std::string_view, 4> extensions = {".off", ".obj", ".ply", ".stl"};
constexpr std::array<Format, 4> formats = {format_off, format_obj, format_ply, format_stl};

std::size_t format_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  const auto* found = std::ranges::find_if(
      extensions, [&](std::string_view known) { return equals_ignoring_case(known, extension); });
  return static_cast<std::size_t>(found - extensions.begin());
}

}  // namespace

std::span<const std::string_view> written_mesh_extensions() { return extensions; }

bool has_written_mesh_extension(const std::filesystem::path& path) {
  return format_of(path) < extensions.size();
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh) {
  const std::size_t format = format_of(path);
  if (format == formats.size()) {
    throw InvalidInput("the name does not end in .off, .obj, .ply or .stl");
  }
  write_file(path, formats[format](mesh));
}

}  // namespace mdbd
