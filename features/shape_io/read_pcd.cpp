// PCD: the header is examined here, since PCL believes what it says; the points are read by PCL.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>

#include "features/core/errors.h"
#include "features/shape_io/plain_file.h"
#include "features/shape_io/point_formats.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

struct Field {
  std::string name;
  std::uint64_t size = 4;    // bytes of a number
  char type = 'F';           // F, I or U
  std::uint64_t count = 1;   // numbers
  std::uint64_t offset = 0;  // bytes, from the beginning of a point
};

enum class Encoding { text, binary, compressed };

struct Header {
  std::vector<Field> fields;
  std::uint64_t points = 0;
  std::uint64_t point_size = 0;  // bytes
  Encoding encoding = Encoding::text;
  std::size_t size = 0;  // bytes

  const Field* find(std::string_view name) const {
    const auto found = std::ranges::find(fields, name, &Field::name);
    return found == fields.end() ? nullptr : &*found;
  }
};

constexpr std::array<std::string_view, 6> used_fields = {"x",        "y",        "z",
                                                         "normal_x", "normal_y", "normal_z"};
constexpr std::size_t most_fields = 100;
constexpr std::uint64_t most_numbers = 100'000;  // of one field; histograms have some hundreds

std::uint64_t read_count(TextCursor& cursor, const std::string& what, std::uint64_t most) {
  const auto number = parse_integer(cursor.next_in_line());
  if (!number || *number < 1 || static_cast<std::uint64_t>(*number) > most) {
    throw InvalidInput("the PCD header has no usable " + what);
  }
  return static_cast<std::uint64_t>(*number);
}

void read_names(TextCursor& cursor, Header& header) {
  header.fields.clear();
  for (std::string_view word = cursor.next_in_line(); !word.empty(); word = cursor.next_in_line()) {
    if (header.fields.size() == most_fields) throw InvalidInput("the PCD header has > 100 fields");
    header.fields.push_back({.name = std::string(word.substr(0, 100))});
  }
}

char read_type(TextCursor& cursor) {
  const std::string_view word = cursor.next_in_line();
  if (word != "F" && word != "I" && word != "U") {
    throw InvalidInput("the PCD header has a type that is none of F, I and U");
  }
  return word.front();
}

Encoding read_encoding(TextCursor& cursor) {
  const std::string_view word = cursor.next_in_line();
  if (word == "ascii") return Encoding::text;
  if (word == "binary") return Encoding::binary;
  if (word == "binary_compressed") return Encoding::compressed;
  throw InvalidInput("the PCD header has no DATA: ascii, binary or binary_compressed");
}

void check_fields(Header& header) {
  for (Field& field : header.fields) {
    const bool is_known = field.type == 'F' ? field.size == 4 || field.size == 8
                                            : field.size == 1 || field.size == 2 ||
                                                  field.size == 4 || field.size == 8;
    if (!is_known) throw InvalidInput("the PCD header has a field of unknown size");
    field.offset = header.point_size;
    header.point_size += field.size * field.count;
  }
  for (const std::string_view name : {"x", "y", "z"}) {
    const Field* field = header.find(name);
    if (field == nullptr) throw InvalidInput("the PCD file has no fields x, y and z");
    if (field->type != 'F' || field->count != 1) {
      throw InvalidInput("the coordinates of the PCD file are no floating-point numbers");
    }
  }
}

// A point has at least one character for each number and one behind it.
void check_room(const Header& header, std::size_t file_size) {
  if (header.encoding == Encoding::compressed) return;
  std::uint64_t numbers = 0;
  for (const Field& field : header.fields) numbers += field.count;
  const bool is_text = header.encoding == Encoding::text;
  const std::uint64_t least =
      is_text ? std::max<std::uint64_t>(2 * numbers, 1) - 1 : header.point_size;
  require_room(header.points, least, "points", file_size);
}

Header read_header(std::string_view bytes) {
  TextCursor cursor(bytes);
  Header header;
  std::uint64_t width = 0;
  std::uint64_t height = 1;
  constexpr std::uint64_t most_points = 0x7fffffff;
  for (; !cursor.at_end(); cursor.skip_line()) {
    const std::string_view keyword = cursor.next_in_line();
    if (keyword == "FIELDS" || keyword == "COLUMNS") {
      read_names(cursor, header);
    } else if (keyword == "SIZE") {
      for (Field& field : header.fields) field.size = read_count(cursor, "SIZE", 8);
    } else if (keyword == "TYPE") {
      for (Field& field : header.fields) field.type = read_type(cursor);
    } else if (keyword == "COUNT") {
      for (Field& field : header.fields) field.count = read_count(cursor, "COUNT", most_numbers);
    } else if (keyword == "WIDTH") {
      width = read_count(cursor, "WIDTH", most_points);
    } else if (keyword == "HEIGHT") {
      height = read_count(cursor, "HEIGHT", most_points);
    } else if (keyword == "POINTS") {
      header.points = read_count(cursor, "POINTS", most_points);
    } else if (keyword == "DATA") {
      header.encoding = read_encoding(cursor);
      cursor.skip_line();
      header.size = cursor.position();
      if (header.points == 0) header.points = width * height;
      if (width * height != header.points || header.points > most_points) {
        throw InvalidInput("the PCD header has other numbers of points than WIDTH times HEIGHT");
      }
      check_fields(header);
      check_room(header, bytes.size());
      return header;
    } else if (!keyword.empty() && keyword != "VERSION" && keyword != "VIEWPOINT") {
      break;
    }
  }
  throw InvalidInput("not a PCD file: it has no header that ends with DATA");
}

/// A header of our own for PCL, which says the same in its order.
std::string plain_header(const Header& header) {
  std::string names = "FIELDS";
  std::string sizes = "SIZE";
  std::string types = "TYPE";
  std::string counts = "COUNT";
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    const Field& field = header.fields[i];
    // What a name is to PCL ("_" is padding) does not matter for fields that are not used.
    const bool is_used = std::ranges::count(used_fields, field.name) > 0;
    names += " " + (is_used ? field.name : "field_" + std::to_string(i));
    sizes += " " + std::to_string(field.size);
    types += std::string(" ") + field.type;
    counts += " " + std::to_string(field.count);
  }
  constexpr const char* encodings[] = {"ascii", "binary", "binary_compressed"};
  return "VERSION 0.7\n" + names + "\n" + sizes + "\n" + types + "\n" + counts + "\nWIDTH " +
         std::to_string(header.points) + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         std::to_string(header.points) + "\nDATA " +
         encodings[static_cast<std::size_t>(header.encoding)] + "\n";
}

// PCL reads past the end of what is too short.
void check_body(const Header& header, std::string_view body) {
  if (header.encoding == Encoding::binary && body.size() < header.points * header.point_size) {
    throw InvalidInput("truncated: the file ends after " +
                       std::to_string(body.size() / header.point_size) + " of " +
                       std::to_string(header.points) + " points");
  }
  if (header.encoding != Encoding::compressed) return;
  std::uint32_t sizes[2];  // compressed and not
  if (body.size() < sizeof sizes) throw InvalidInput("truncated: the file ends after its header");
  std::memcpy(sizes, body.data(), sizeof sizes);
  if (sizes[0] > body.size() - sizeof sizes) {
    throw InvalidInput("truncated: the file has less compressed data than it says");
  }
  // A step of LZF makes at most 264 bytes of three.
  if (sizes[1] != header.points * header.point_size || sizes[1] / 88 > sizes[0]) {
    throw InvalidInput("the compressed data are not of the size that the header gives");
  }
}

/// Requires as many numbers in each line as a point has; PCL makes zeros of what is no number.
void check_lines(const Header& header, std::string_view body) {
  std::uint64_t numbers = 0;
  for (const Field& field : header.fields) numbers += field.count;
  TextCursor cursor(body);
  for (std::uint64_t point = 0; point < header.points; ++point) {
    for (std::uint64_t i = 0; i < numbers; ++i) {
      const std::string_view word = i == 0 ? cursor.next() : cursor.next_in_line();
      if (word.empty() && cursor.remaining() == 0) {
        throw InvalidInput("truncated: the file ends after " + std::to_string(point) + " of " +
                           std::to_string(header.points) + " points");
      }
      if (!parse_number(word)) {
        throw InvalidInput("point " + std::to_string(point) + " of the PCD file: '" +
                           std::string(word.substr(0, 40)) + "' is no number");
      }
    }
    cursor.skip_line();
  }
}

pcl::PCLPointCloud2 read_with_pcl(const Header& header, std::string_view body) {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  std::istringstream stream(plain_header(header));
  stream.imbue(std::locale::classic());
  pcl::PCLPointCloud2 cloud;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  int data_type = 0;
  unsigned int data_index = 0;
  pcl::PCDReader reader;
  int result =
      reader.readHeader(stream, cloud, origin, orientation, version, data_type, data_index);
  if (result == 0 && header.encoding == Encoding::text) {
    std::istringstream text{std::string(body)};
    text.imbue(std::locale::classic());
    result = reader.readBodyASCII(text, cloud, version);
  } else if (result == 0) {
    result = reader.readBodyBinary(reinterpret_cast<const unsigned char*>(body.data()), cloud,
                                   version, header.encoding == Encoding::compressed, 0);
  }
  if (result != 0 || cloud.data.size() < header.points * cloud.point_step) {
    throw InvalidInput("PCL cannot read the file");
  }
  return cloud;
}

/// The numbers of one field, for each point.
std::vector<double> numbers_of(const pcl::PCLPointCloud2& cloud, const std::string& name) {
  const auto field = std::ranges::find(cloud.fields, name, &pcl::PCLPointField::name);
  const bool is_double = field->datatype == pcl::PCLPointField::FLOAT64;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < cloud.width; ++i) {
    const std::uint8_t* at = &cloud.data[i * cloud.point_step + field->offset];
    double number = 0.0;
    if (is_double) {
      std::memcpy(&number, at, sizeof number);
    } else {
      float single = 0.0F;
      std::memcpy(&single, at, sizeof single);
      number = single;
    }
    numbers.push_back(number);
  }
  return numbers;
}

std::vector<Eigen::Vector3d> vectors_of(const pcl::PCLPointCloud2& cloud,
                                        const std::string& prefix) {
  const std::vector<double> x = numbers_of(cloud, prefix + "x");
  const std::vector<double> y = numbers_of(cloud, prefix + "y");
  const std::vector<double> z = numbers_of(cloud, prefix + "z");
  std::vector<Eigen::Vector3d> vectors;
  for (std::size_t i = 0; i < x.size(); ++i) vectors.emplace_back(x[i], y[i], z[i]);
  return vectors;
}

bool has_normals(const Header& header) {
  return std::ranges::all_of(used_fields, [&](std::string_view name) {
    const Field* field = header.find(name);
    return field != nullptr && field->type == 'F' && field->count == 1;
  });
}

}  // namespace

PointCloud read_pcd(std::string_view bytes) {
  const Header header = read_header(bytes);
  const std::string_view body = bytes.substr(header.size);
  if (header.points == 0) throw InvalidInput("the file has no points");
  check_body(header, body);
  if (header.encoding == Encoding::text) check_lines(header, body);
  const pcl::PCLPointCloud2 cloud = read_with_pcl(header, body);
  PointCloud result{.points = vectors_of(cloud, ""), .normals = {}};
  if (has_normals(header)) result.normals = vectors_of(cloud, "normal_");
  return result;
}

}  // namespace mdbd
