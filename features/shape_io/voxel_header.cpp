// After "Definition of NRRD File Format" (teem.sourceforge.net/nrrd/format.html), the documentation
// of MetaIO (itk.org/Wiki/MetaIO) and "VTK File Formats" (Kitware).
#include "features/shape_io/voxel_header.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "features/core/errors.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

using Number = VoxelHeader::Number;
using Encoding = VoxelHeader::Encoding;

constexpr std::size_t longest_header = 1 << 20;  // bytes
constexpr std::uint64_t most_points = std::uint64_t{1} << 27;

/// A word of a file, fit for a message.
std::string quoted(std::string_view word) {
  std::string text(word.substr(0, 40));
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + "'";
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Hands out a text line by line.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  bool at_end() const { return position_ >= std::min(text_.size(), longest_header); }
  std::size_t position() const { return position_; }
  std::string_view next() {
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    const std::string_view line = text_.substr(position_, end - position_);
    position_ = std::min(end + 1, text_.size());
    return trimmed(line);
  }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
};

/// The fields of a header, by name.
class Fields {
 public:
  void set(std::string_view name, std::string_view value) { values_[std::string(name)] = value; }

  std::optional<std::string_view> find(std::initializer_list<const char*> names) const {
    for (const char* name : names) {
      const auto found = values_.find(name);
      if (found != values_.end()) return found->second;
    }
    return std::nullopt;
  }

  std::string_view get(std::initializer_list<const char*> names) const {
    const auto value = find(names);
    if (!value) throw InvalidInput("the header has no \"" + std::string(*names.begin()) + "\"");
    return *value;
  }

 private:
  std::map<std::string, std::string_view> values_;
};

/// Numbers, whatever brackets and commas stand between them.
std::vector<double> read_numbers(std::string_view text, std::size_t count, const char* what) {
  std::string plain(text);
  std::ranges::replace_if(
      plain, [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  TextCursor cursor(plain);
  std::vector<double> numbers;
  for (auto word = cursor.next(); !word.empty(); word = cursor.next()) {
    const auto number = parse_number(word);
    if (!number || !(std::abs(*number) <= 1e30)) {
      throw InvalidInput(std::string("the header's ") + what + " has no usable number " +
                         quoted(word));
    }
    numbers.push_back(*number);
  }
  if (numbers.size() != count) {
    throw InvalidInput(std::string("the header's ") + what + " has not " + std::to_string(count) +
                       " numbers");
  }
  return numbers;
}

Eigen::Vector3d read_vector(std::string_view text, const char* what) {
  const std::vector<double> numbers = read_numbers(text, 3, what);
  return {numbers[0], numbers[1], numbers[2]};
}

/// Nine numbers, axis after axis.
Eigen::Matrix3d read_axes(std::string_view text, const char* what) {
  const std::vector<double> numbers = read_numbers(text, 9, what);
  return Eigen::Map<const Eigen::Matrix3d>(numbers.data());
}

void set_size(VoxelHeader& header, std::string_view text) {
  std::uint64_t points = 1;
  TextCursor cursor(text);
  for (std::uint64_t& size : header.size) {
    const auto number = parse_integer(cursor.next());
    if (!number || *number < 1 || static_cast<std::uint64_t>(*number) > most_points / points) {
      throw InvalidInput("the grid has not three sizes that multiply to 1 to 512^3 points");
    }
    size = static_cast<std::uint64_t>(*number);
    points *= size;
  }
  if (!cursor.next().empty()) throw InvalidInput("the grid has more than three sizes");
}

void require_three(std::string_view dimension) {
  if (parse_integer(dimension) == 3) return;
  throw InvalidInput("the grid has " + quoted(dimension) + " dimensions, not 3");
}

/// @param names with the number that each stands for
Number number_type(std::string_view name,
                   std::initializer_list<std::pair<std::string_view, Number>> names) {
  for (const auto& [known, number] : names) {
    if (name == known) return number;
  }
  throw InvalidInput("the grid's values are of an unknown type " + quoted(name));
}

Number nrrd_number(std::string_view name) {
  return number_type(name, {{"signed char", Number::i8},
                            {"int8", Number::i8},
                            {"int8_t", Number::i8},
                            {"uchar", Number::u8},
                            {"unsigned char", Number::u8},
                            {"uint8", Number::u8},
                            {"uint8_t", Number::u8},
                            {"short", Number::i16},
                            {"short int", Number::i16},
                            {"int16", Number::i16},
                            {"int16_t", Number::i16},
                            {"ushort", Number::u16},
                            {"unsigned short", Number::u16},
                            {"uint16", Number::u16},
                            {"uint16_t", Number::u16},
                            {"int", Number::i32},
                            {"signed int", Number::i32},
                            {"int32", Number::i32},
                            {"int32_t", Number::i32},
                            {"uint", Number::u32},
                            {"unsigned int", Number::u32},
                            {"uint32", Number::u32},
                            {"uint32_t", Number::u32},
                            {"longlong", Number::i64},
                            {"long long", Number::i64},
                            {"int64", Number::i64},
                            {"int64_t", Number::i64},
                            {"ulonglong", Number::u64},
                            {"unsigned long long", Number::u64},
                            {"uint64", Number::u64},
                            {"uint64_t", Number::u64},
                            {"float", Number::f32},
                            {"double", Number::f64}});
}

Fields nrrd_fields(std::string_view bytes, std::size_t& end) {
  Lines lines(bytes);
  Fields fields;
  lines.next();  // the magic
  while (!lines.at_end()) {
    const std::string_view line = lines.next();
    if (line.empty()) break;
    if (line.front() == '#') continue;
    const std::size_t colon = line.find(':');
    if (colon == line.npos)
      throw InvalidInput("a line of the header has no colon: " + quoted(line));
    if (line.substr(colon).starts_with(":=")) continue;  // a remark for others
    fields.set(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
  }
  end = std::min(lines.position(), bytes.size());
  return fields;
}

Encoding nrrd_encoding(std::string_view name) {
  if (name == "raw") return Encoding::raw;
  if (name == "ascii" || name == "text" || name == "txt") return Encoding::text;
  if (name == "gzip" || name == "gz") return Encoding::compressed;
  throw InvalidInput("the grid is encoded as " + quoted(name) + ", not as raw, ascii or gzip");
}

bool is_true(std::string_view word) { return equals_ignoring_case(word, "true") || word == "1"; }

}  // namespace

VoxelHeader read_nrrd_header(std::string_view bytes) {
  if (!bytes.starts_with("NRRD000")) throw InvalidInput("not a NRRD file: it has no NRRD000");
  VoxelHeader header;
  const Fields fields = nrrd_fields(bytes, header.data_offset);
  require_three(fields.get({"dimension"}));
  set_size(header, fields.get({"sizes"}));
  header.number = nrrd_number(fields.get({"type"}));
  header.encoding = nrrd_encoding(fields.get({"encoding"}));
  header.is_big_endian = fields.find({"endian"}).value_or("little") == "big";
  if (const auto axes = fields.find({"space directions"})) {
    header.steps = read_axes(*axes, "space directions");
  } else if (const auto spacings = fields.find({"spacings"})) {
    header.steps = read_vector(*spacings, "spacings").asDiagonal();
  }
  if (const auto origin = fields.find({"space origin", "axis mins"})) {
    header.origin = read_vector(*origin, "origin");
  }
  for (const char* skip : {"byte skip", "line skip", "byteskip", "lineskip"}) {
    if (fields.find({skip}).value_or("0") != "0") {
      throw InvalidInput(std::string("a ") + skip + " is not supported");
    }
  }
  if (const auto file = fields.find({"data file", "datafile"})) {
    header.data_file = *file;
    header.data_offset = 0;
  }
  return header;
}

VoxelHeader read_metaimage_header(std::string_view bytes) {
  Lines lines(bytes);
  Fields fields;
  bool is_complete = false;
  while (!lines.at_end() && !is_complete) {
    const std::string_view line = lines.next();
    const std::size_t sign = line.find('=');
    if (sign == line.npos)
      throw InvalidInput("not a MetaImage file: a line of its header has no =");
    const std::string_view name = trimmed(line.substr(0, sign));
    fields.set(name, trimmed(line.substr(sign + 1)));
    is_complete = name == "ElementDataFile";
  }
  if (!is_complete) throw InvalidInput("not a MetaImage file: its header has no ElementDataFile");
  VoxelHeader header;
  require_three(fields.get({"NDims"}));
  set_size(header, fields.get({"DimSize"}));
  header.number = number_type(fields.get({"ElementType"}), {{"MET_CHAR", Number::i8},
                                                            {"MET_UCHAR", Number::u8},
                                                            {"MET_SHORT", Number::i16},
                                                            {"MET_USHORT", Number::u16},
                                                            {"MET_INT", Number::i32},
                                                            {"MET_UINT", Number::u32},
                                                            {"MET_LONG_LONG", Number::i64},
                                                            {"MET_ULONG_LONG", Number::u64},
                                                            {"MET_FLOAT", Number::f32},
                                                            {"MET_DOUBLE", Number::f64}});
  if (fields.find({"ElementNumberOfChannels"}).value_or("1") != "1") {
    throw InvalidInput("the grid has several values at a point");
  }
  if (fields.find({"HeaderSize"}).value_or("0") != "0") {
    throw InvalidInput("a HeaderSize is not supported");
  }
  if (!is_true(fields.find({"BinaryData"}).value_or("True"))) header.encoding = Encoding::text;
  if (is_true(fields.find({"CompressedData"}).value_or("False"))) {
    header.encoding = Encoding::compressed;
  }
  header.is_big_endian =
      is_true(fields.find({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}).value_or("False"));
  if (const auto axes = fields.find({"TransformMatrix", "Rotation", "Orientation"})) {
    header.steps = read_axes(*axes, "TransformMatrix");
  }
  if (const auto spacing = fields.find({"ElementSpacing", "ElementSize"})) {
    header.steps = header.steps * read_vector(*spacing, "ElementSpacing").asDiagonal();
  }
  if (const auto origin = fields.find({"Offset", "Position", "Origin"})) {
    header.origin = read_vector(*origin, "Offset");
  }
  const std::string_view file = fields.get({"ElementDataFile"});
  if (equals_ignoring_case(file, "LOCAL")) {
    header.data_offset = std::min(lines.position(), bytes.size());
  } else {
    header.data_file = file;
  }
  return header;
}

VoxelHeader read_vtk_header(std::string_view bytes) {
  Lines lines(bytes);
  if (!lines.next().starts_with("# vtk DataFile")) {
    throw InvalidInput("not a legacy VTK file: it does not begin with # vtk DataFile");
  }
  lines.next();  // the title
  VoxelHeader header;
  const std::string_view encoding = lines.next();
  if (encoding != "ASCII" && encoding != "BINARY") {
    throw InvalidInput("the VTK file is neither ASCII nor BINARY");
  }
  header.encoding = encoding == "ASCII" ? Encoding::text : Encoding::raw;
  header.is_big_endian = true;
  bool has_number = false;
  while (!lines.at_end()) {
    const std::string_view line = lines.next();
    TextCursor words(line);
    const std::string_view keyword = words.next();
    const std::string_view rest = line.substr(std::min(words.position(), line.size()));
    if (keyword == "DATASET") {
      if (trimmed(rest) != "STRUCTURED_POINTS") {
        throw InvalidInput("the VTK file is no grid of STRUCTURED_POINTS but " +
                           quoted(trimmed(rest)));
      }
    } else if (keyword == "DIMENSIONS") {
      set_size(header, rest);
    } else if (keyword == "ORIGIN") {
      header.origin = read_vector(rest, "ORIGIN");
    } else if (keyword == "SPACING" || keyword == "ASPECT_RATIO") {
      header.steps = read_vector(rest, "SPACING").asDiagonal();
    } else if (keyword == "SCALARS") {
      words.next();  // the name
      header.number = number_type(words.next(), {{"char", Number::i8},
                                                 {"unsigned_char", Number::u8},
                                                 {"short", Number::i16},
                                                 {"unsigned_short", Number::u16},
                                                 {"int", Number::i32},
                                                 {"unsigned_int", Number::u32},
                                                 {"long", Number::i64},
                                                 {"unsigned_long", Number::u64},
                                                 {"float", Number::f32},
                                                 {"double", Number::f64}});
      const std::string_view components = words.next();
      if (!components.empty() && components != "1") {
        throw InvalidInput("the grid has several values at a point");
      }
      has_number = true;
    } else if (keyword == "LOOKUP_TABLE" && has_number) {
      if (header.size[0] == 0) throw InvalidInput("the VTK file has no DIMENSIONS");
      header.data_offset = std::min(lines.position(), bytes.size());
      return header;
    } else if (!keyword.empty() && keyword != "POINT_DATA") {
      throw InvalidInput("the VTK file has " + quoted(keyword) +
                         " where the SCALARS of its points were expected");
    }
  }
  throw InvalidInput("the VTK file has no SCALARS of points with a LOOKUP_TABLE");
}

}  // namespace mdbd
