#include "features/shape_io/plain_file.h"

#include <charconv>
#include <iterator>
#include <utility>

#include "features/core/errors.h"

namespace mdbd {
namespace {

constexpr double largest_coordinate = 1e30;  // fits single precision, and its cube double precision

template <typename Number>
void append_number(std::string& text, Number number, char separator) {
  char buffer[32];
  const auto result = std::to_chars(std::begin(buffer), std::end(buffer), number);
  text.append(buffer, result.ptr);
  text += separator;
}

}  // namespace

void require_usable(const Eigen::Vector3d& vertex, std::uint64_t number) {
  if (!vertex.allFinite()) {
    throw InvalidInput("vertex " + std::to_string(number) + " has a coordinate that is not finite");
  }
  if (vertex.cwiseAbs().maxCoeff() > largest_coordinate) {
    throw InvalidInput("vertex " + std::to_string(number) + " has a coordinate beyond 1e30");
  }
}

void require_faces(std::uint64_t vertices, std::uint64_t faces) {
  if (faces > 0) return;
  throw InvalidInput(vertices > 0 ? "the file has points but no faces"
                                  : "the file has neither points nor faces");
}

void require_room(std::uint64_t count, std::uint64_t least_bytes, std::string_view what,
                  std::uint64_t file_size) {
  if (least_bytes == 0 || count <= file_size / least_bytes) return;
  throw InvalidInput("claims " + std::to_string(count) + " " + std::string(what) +
                     ", but the file has only " + std::to_string(file_size) + " bytes");
}

void PlainOffWriter::add_vertex(const Eigen::Vector3d& vertex) {
  require_usable(vertex, vertices());
  append_number(vertex_lines_, static_cast<float>(vertex.x()), ' ');
  append_number(vertex_lines_, static_cast<float>(vertex.y()), ' ');
  append_number(vertex_lines_, static_cast<float>(vertex.z()), '\n');
  coordinates_.push_back(vertex);
}

void PlainOffWriter::add_face(std::span<const std::uint32_t> corners) {
  append_number(face_lines_, corners.size(), ' ');
  for (const std::uint32_t corner : corners) append_number(face_lines_, corner, ' ');
  face_lines_ += '\n';
  ++faces_;
}

PlainFile PlainOffWriter::finish() {
  require_faces(vertices(), faces_);
  PlainFile file;
  file.extension = "off";
  file.vertices = vertices();
  file.faces = faces_;
  file.bytes = "OFF\n";
  append_number(file.bytes, vertices(), ' ');
  append_number(file.bytes, faces_, ' ');
  file.bytes += "0\n";
  file.bytes += vertex_lines_;
  file.bytes += face_lines_;
  file.coordinates = std::move(coordinates_);
  return file;
}

}  // namespace mdbd
