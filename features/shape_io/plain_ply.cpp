// PLY: of whatever elements, properties, types and encoding a file has, the coordinates and the
// corner lists remain, in little-endian binary. OpenMesh's reader cannot skip lists, coordinates of
// integer type or signed list lengths, and never ends on a header without end_header.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "features/core/errors.h"
#include "features/shape_io/plain_file.h"
#include "features/shape_io/point_formats.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

enum class Encoding { text, little_endian, big_endian };

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Type type;
  std::optional<Type> length_type;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
  std::size_t size = 0;  // bytes
};

std::size_t size_of(Type type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

Type parse_type(std::string_view name) {
  constexpr std::pair<std::string_view, Type> types[] = {
      {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
      {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
      {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
      {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
      {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
      {"float64", Type::float64}};
  const auto* found = std::ranges::find(types, name, &std::pair<std::string_view, Type>::first);
  if (found == std::end(types)) {
    throw InvalidInput("the PLY header has a property of unknown type '" +
                       std::string(name.substr(0, 40)) + "'");
  }
  return found->second;
}

Encoding parse_encoding(std::string_view name) {
  if (name == "ascii") return Encoding::text;
  if (name == "binary_little_endian") return Encoding::little_endian;
  if (name == "binary_big_endian") return Encoding::big_endian;
  throw InvalidInput(
      "the PLY header has no format: ascii, binary_little_endian or binary_big_endian");
}

Element read_element(TextCursor& cursor) {
  const std::string_view name = cursor.next_in_line();
  const auto count = parse_integer(cursor.next_in_line());
  if (!count || *count < 0) {
    throw InvalidInput("the PLY header has no number of '" + std::string(name.substr(0, 40)) + "'");
  }
  return {std::string(name), static_cast<std::uint64_t>(*count), {}};
}

Property read_property(TextCursor& cursor) {
  std::string_view type = cursor.next_in_line();
  std::optional<Type> length_type;
  if (type == "list") {
    length_type = parse_type(cursor.next_in_line());
    if (*length_type == Type::float32 || *length_type == Type::float64) {
      throw InvalidInput("the PLY header has a list whose length is not an integer");
    }
    type = cursor.next_in_line();
  }
  const Type value_type = parse_type(type);
  return {std::string(cursor.next_in_line()), value_type, length_type};
}

Header read_header(std::string_view bytes) {
  TextCursor cursor(bytes);
  if (!equals_ignoring_case(cursor.next_in_line(), "ply")) {
    throw InvalidInput("not a PLY file: it does not begin with ply");
  }
  Header header;
  bool has_format = false;
  for (cursor.skip_line(); !cursor.at_end(); cursor.skip_line()) {
    const std::string_view keyword = cursor.next_in_line();
    if (keyword == "format") {
      header.encoding = parse_encoding(cursor.next_in_line());
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(cursor));
    } else if (keyword == "property") {
      if (header.elements.empty())
        throw InvalidInput("the PLY header has a property of no element");
      header.elements.back().properties.push_back(read_property(cursor));
    } else if (keyword == "end_header") {
      if (!has_format) parse_encoding("");
      cursor.skip_line();
      header.size = cursor.position();
      return header;
    }
  }
  throw InvalidInput("truncated: the PLY header has no end_header");
}

/// The values of the body, one after the other, whatever their encoding.
class ValueReader {
 public:
  ValueReader(std::string_view bytes, const Header& header)
      : cursor_(bytes), bytes_(bytes), encoding_(header.encoding) {
    cursor_.move_to(header.size);
  }

  /// Nothing if the file ends before.
  std::optional<double> next(Type type) {
    if (encoding_ == Encoding::text) return next_word();
    switch (type) {
      case Type::int8:
        return next_binary<std::int8_t>();
      case Type::uint8:
        return next_binary<std::uint8_t>();
      case Type::int16:
        return next_binary<std::int16_t>();
      case Type::uint16:
        return next_binary<std::uint16_t>();
      case Type::int32:
        return next_binary<std::int32_t>();
      case Type::uint32:
        return next_binary<std::uint32_t>();
      case Type::float32:
        return next_binary<float>();
      case Type::float64:
        return next_binary<double>();
    }
    return std::nullopt;
  }

  std::size_t remaining() const { return cursor_.remaining(); }

  /// The least number of bytes that a value of this type takes.
  std::uint64_t least_size(Type type) const {
    return encoding_ == Encoding::text ? 1 : size_of(type);
  }

 private:
  std::optional<double> next_word() {
    const std::string_view word = cursor_.next();
    if (word.empty()) return std::nullopt;
    const auto number = parse_number(word);
    if (!number) {
      throw InvalidInput("line " + std::to_string(cursor_.line()) + ": '" +
                         std::string(word.substr(0, 40)) + "' is no number");
    }
    return number;
  }

  template <typename Number>
  std::optional<double> next_binary() {
    std::array<char, sizeof(Number)> raw;
    if (remaining() < raw.size()) return std::nullopt;
    std::memcpy(raw.data(), bytes_.data() + cursor_.position(), raw.size());
    cursor_.move_to(cursor_.position() + raw.size());
    if (encoding_ == Encoding::big_endian) std::ranges::reverse(raw);
    return static_cast<double>(std::bit_cast<Number>(raw));
  }

  TextCursor cursor_;
  std::string_view bytes_;
  Encoding encoding_;
};

// A number that is to be an index or a length; -1 if it is none.
std::int64_t to_integer(double number) {
  const bool is_index = number >= 0 && number <= invalid_index && std::trunc(number) == number;
  return is_index ? static_cast<std::int64_t>(number) : -1;
}

/// Goes through the body of a file and gathers what the plain file keeps.
class BodyReader {
 public:
  BodyReader(std::string_view bytes, const Header& header) : values_(bytes, header) {
    for (const Element& element : header.elements) require_room(element, bytes.size());
    for (const Element& element : header.elements) {
      if (!element.properties.empty()) read(element);
    }
  }

  /// The vertices, with normals if all have them.
  PointCloud finish_points() {
    if (coordinates_.empty()) throw InvalidInput("the file has no points");
    if (normals_.size() != coordinates_.size()) normals_.clear();
    return {std::move(coordinates_), std::move(normals_)};
  }

  PlainFile finish() {
    require_usable_vertices();
    require_faces(coordinates_.size(), faces_);
    PlainFile file;
    file.extension = "ply";
    file.is_binary = true;
    file.vertices = coordinates_.size();
    file.faces = faces_;
    file.bytes = header();
    for (const Eigen::Vector3d& vertex : coordinates_) {
      for (const double coordinate : vertex) append(file.bytes, static_cast<float>(coordinate));
    }
    file.bytes += face_bytes_;
    file.coordinates = std::move(coordinates_);
    return file;
  }

 private:
  void require_room(const Element& element, std::uint64_t file_size) const {
    std::uint64_t least_bytes = 0;
    for (const Property& property : element.properties) {
      least_bytes += values_.least_size(property.length_type.value_or(property.type));
    }
    const bool is_vertex = element.name == "vertex";
    const std::string what = is_vertex                ? "vertices"
                             : element.name == "face" ? "faces"
                                                      : "'" + element.name.substr(0, 40) + "'";
    mdbd::require_room(element.count, least_bytes, what, file_size);
  }

  void read(const Element& element) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      bool is_complete = true;
      if (element.name == "vertex") {
        is_complete = read_vertex(element);
      } else {
        for (const Property& property : element.properties) {
          is_complete = is_complete && read_values(property);
          if (is_complete && element.name == "face" && is_corner_list(property)) add_face();
        }
      }
      if (!is_complete) {
        throw InvalidInput("truncated: the file ends after " + std::to_string(i) + " of " +
                           std::to_string(element.count) + " of the element '" +
                           element.name.substr(0, 40) + "'");
      }
    }
  }

  static bool is_corner_list(const Property& property) {
    return property.length_type &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  bool read_vertex(const Element& element) {
    std::array<std::optional<double>, 3> vertex;
    std::array<std::optional<double>, 3> normal;
    for (const Property& property : element.properties) {
      if (!read_values(property)) return false;
      if (property.length_type || property.name.empty()) continue;
      const std::size_t axis = std::string_view("xyz").find(property.name.back());
      if (axis >= 3) continue;
      if (property.name.size() == 1) vertex[axis] = list_[0];
      if (property.name.size() == 2 && property.name.front() == 'n') normal[axis] = list_[0];
    }
    if (!vertex[0] || !vertex[1] || !vertex[2]) {
      throw InvalidInput("the vertices of the PLY file have no x, y and z");
    }
    coordinates_.emplace_back(*vertex[0], *vertex[1], *vertex[2]);
    if (normal[0] && normal[1] && normal[2]) {
      normals_.emplace_back(*normal[0], *normal[1], *normal[2]);
    }
    return true;
  }

  void require_usable_vertices() const {
    for (std::size_t i = 0; i < coordinates_.size(); ++i) require_usable(coordinates_[i], i);
  }

  // Reads one value, or the values of a list, into list_; false if the file ends before.
  bool read_values(const Property& property) {
    list_.clear();
    std::int64_t length = 1;
    if (property.length_type) {
      const auto number = values_.next(*property.length_type);
      if (!number) return false;
      length = to_integer(*number);
      if (length < 0) throw InvalidInput("a list of the PLY file has no valid length");
      if (static_cast<std::uint64_t>(length) * values_.least_size(property.type) >
          values_.remaining()) {
        return false;
      }
    }
    for (std::int64_t i = 0; i < length; ++i) {
      const auto value = values_.next(property.type);
      if (!value) return false;
      list_.push_back(*value);
    }
    return true;
  }

  void add_face() {
    append(face_bytes_, static_cast<std::uint32_t>(list_.size()));
    for (const double corner : list_) append(face_bytes_, to_index(to_integer(corner)));
    ++faces_;
  }

  template <typename Number>
  static void append(std::string& bytes, Number number) {
    const auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
    bytes.append(raw.data(), raw.size());
  }

  std::string header() const {
    return "ply\nformat binary_little_endian 1.0\nelement vertex " +
           std::to_string(coordinates_.size()) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(faces_) + "\nproperty list int uint vertex_indices\nend_header\n";
  }

  ValueReader values_;
  std::vector<double> list_;
  std::vector<Eigen::Vector3d> coordinates_;
  std::vector<Eigen::Vector3d> normals_;
  std::string face_bytes_;
  std::uint64_t faces_ = 0;
};

}  // namespace

PlainFile plain_ply(std::string_view bytes) {
  return BodyReader(bytes, read_header(bytes)).finish();
}

PointCloud read_ply_points(std::string_view bytes) {
  return BodyReader(bytes, read_header(bytes)).finish_points();
}

bool has_ply_points_alone(std::string_view beginning) {
  try {
    const Header header = read_header(beginning);
    const auto has = [&](std::string_view name) {
      return std::ranges::any_of(header.elements, [&](const Element& element) {
        return element.name == name && element.count > 0;
      });
    };
    return has("vertex") && !has("face") && !has("tristrips");
  } catch (const InvalidInput&) {
    return false;
  }
}

}  // namespace mdbd
