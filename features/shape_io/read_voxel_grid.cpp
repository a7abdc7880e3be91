#include "features/shape_io/read_voxel_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <Eigen/LU>
#include <zlib.h>

#include "features/core/errors.h"
#include "features/shape_io/input_file.h"
#include "features/shape_io/plain_file.h"
#include "features/shape_io/text_cursor.h"
#include "features/shape_io/voxel_header.h"
#include "features/shape_io/vti_reader.h"

namespace mdbd {
namespace {

using Number = VoxelHeader::Number;

constexpr std::array<std::string_view, 6> extensions = {".nrrd", ".nhdr", ".mha",
                                                        ".mhd",  ".vtk",  ".vti"};
constexpr std::uint64_t best_compression = 1032;  // of deflate

VoxelHeader read_header(std::string_view format, std::string_view bytes) {
  if (format == "nrrd" || format == "nhdr") return read_nrrd_header(bytes);
  if (format == "mha" || format == "mhd") return read_metaimage_header(bytes);
  return read_vtk_header(bytes);
}

std::size_t size_of(Number number) {
  constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(number)];
}

template <typename Type>
void append_numbers(std::string_view bytes, bool is_big_endian, std::vector<double>& values) {
  const bool is_other = is_big_endian != (std::endian::native == std::endian::big);
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(Type)) {
    std::array<char, sizeof(Type)> raw;
    std::memcpy(raw.data(), bytes.data() + i, raw.size());
    if (is_other) std::ranges::reverse(raw);
    values.push_back(static_cast<double>(std::bit_cast<Type>(raw)));
  }
}

void append_numbers(Number number, std::string_view bytes, bool is_big_endian,
                    std::vector<double>& values) {
  switch (number) {
    case Number::i8:
      return append_numbers<std::int8_t>(bytes, is_big_endian, values);
    case Number::u8:
      return append_numbers<std::uint8_t>(bytes, is_big_endian, values);
    case Number::i16:
      return append_numbers<std::int16_t>(bytes, is_big_endian, values);
    case Number::u16:
      return append_numbers<std::uint16_t>(bytes, is_big_endian, values);
    case Number::i32:
      return append_numbers<std::int32_t>(bytes, is_big_endian, values);
    case Number::u32:
      return append_numbers<std::uint32_t>(bytes, is_big_endian, values);
    case Number::i64:
      return append_numbers<std::int64_t>(bytes, is_big_endian, values);
    case Number::u64:
      return append_numbers<std::uint64_t>(bytes, is_big_endian, values);
    case Number::f32:
      return append_numbers<float>(bytes, is_big_endian, values);
    case Number::f64:
      return append_numbers<double>(bytes, is_big_endian, values);
  }
}

/// Unpacks what zlib or gzip packed.
std::string inflate_all(std::string_view packed, std::size_t size) {
  z_stream stream = {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string bytes(size, '\0');
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  constexpr int either = 32;
  if (inflateInit2(&stream, MAX_WBITS + either) != Z_OK) {
    throw InvalidInput("zlib cannot begin to unpack");
  }
  const int result = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (stream.avail_out != 0 || (result != Z_STREAM_END && result != Z_BUF_ERROR)) {
    throw InvalidInput("the compressed values are damaged or truncated");
  }
  return bytes;
}

void append_text(std::string_view text, std::size_t count, std::vector<double>& values) {
  TextCursor cursor(text);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view word = cursor.next();
    if (word.empty()) {
      throw InvalidInput("truncated: the file ends after " + std::to_string(i) + " of " +
                         std::to_string(count) + " values");
    }
    const auto number = parse_number(word);
    if (!number) throw InvalidInput("value " + std::to_string(i) + " of the grid is no number");
    values.push_back(*number);
  }
}

std::vector<double> read_values(const VoxelHeader& header, std::string_view data) {
  const std::uint64_t count = header.size[0] * header.size[1] * header.size[2];
  const std::size_t size = size_of(header.number);
  std::vector<double> values;
  switch (header.encoding) {
    case VoxelHeader::Encoding::raw:
      require_room(count, size, "values", data.size());
      values.reserve(count);
      append_numbers(header.number, data.substr(0, count * size), header.is_big_endian, values);
      break;
    case VoxelHeader::Encoding::text:
      require_room(count, 2, "values", data.size() + 1);
      append_text(data, count, values);
      break;
    case VoxelHeader::Encoding::compressed:
      require_room(count * size / best_compression, 1, "values", data.size());
      append_numbers(header.number, inflate_all(data, count * size), header.is_big_endian, values);
      break;
  }
  return values;
}

/// The values of a grid in a file beside its header.
std::string read_data_file(const std::filesystem::path& path, const std::string& name) {
  const std::filesystem::path relative = std::filesystem::path(name).lexically_normal();
  if (relative.is_absolute() || relative.empty() || *relative.begin() == "..") {
    throw InvalidInput("the values are in a file outside of the folder of the header");
  }
  try {
    return read_input_file(path.parent_path() / relative);
  } catch (const IoError& error) {
    throw InvalidInput("the file with the values " + std::string(error.what()));
  }
}

VoxelGrid read_grid(const std::filesystem::path& path, std::string_view format) {
  const std::string bytes = read_input_file(path);
  if (format == "vti") return read_vti(bytes);
  const VoxelHeader header = read_header(format, bytes);
  const std::string other =
      header.data_file.empty() ? std::string() : read_data_file(path, header.data_file);
  const std::string_view data = header.data_file.empty() ? bytes : other;
  VoxelGrid grid;
  for (std::size_t i = 0; i < 3; ++i) grid.size[i] = header.size[i];
  grid.origin = header.origin;
  grid.steps = header.steps;
  grid.values = read_values(header, data.substr(std::min(header.data_offset, data.size())));
  return grid;
}

}  // namespace

std::span<const std::string_view> voxel_file_extensions() { return extensions; }

VoxelFile read_voxel_grid(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  const auto* known = std::ranges::find_if(extensions, [&](std::string_view extension) {
    return equals_ignoring_case(extension, ending);
  });
  if (known == extensions.end()) {
    throw InvalidInput("the name does not end in .nrrd, .nhdr, .mha, .mhd, .vtk or .vti");
  }
  VoxelFile file;
  file.format = known->substr(1);
  file.grid = read_grid(path, file.format);
  const auto is_bad = [](double value) { return !std::isfinite(value); };
  if (std::ranges::any_of(file.grid.values, is_bad)) {
    throw InvalidInput("the grid has values that are not finite");
  }
  if (!file.grid.steps.allFinite() || !file.grid.origin.allFinite() ||
      !(std::abs(file.grid.steps.determinant()) > 0)) {
    throw InvalidInput("the axes of the grid do not span space");
  }
  return file;
}

}  // namespace mdbd
