#include "db/export_arrays.h"

#include <bit>
#include <cstdint>
#include <functional>
#include <iterator>

#include <fmt/format.h>

#include "cli/text_output.h"
#include "features/core/errors.h"
#include "store/blob_codec.h"

namespace mdbd {
namespace {

void append_bytes(std::span<const std::byte> bytes, std::string& content) {
  content.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

void append_little_endian(std::uint64_t value, int bytes, std::string& content) {
  for (int i = 0; i < bytes; ++i) content += static_cast<char>(value >> 8 * i & 0xff);
}

/// The header of the file format (numpy.lib.format, version 1.0): the data begins at a multiple of
/// 64 bytes.
std::string npy_header(const std::string& type, const std::string& shape) {
  constexpr std::size_t prefix_size = 10;
  constexpr std::size_t alignment = 64;
  std::string description =
      fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': ({}), }}", type, shape);
  const std::size_t used = prefix_size + description.size() + 1;
  description.append((alignment - used % alignment) % alignment, ' ');
  description += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  append_little_endian(description.size(), 2, header);
  return header + description;
}

void for_each_indexed(const ShapeStore& store,
                      const std::function<void(const ShapeRecord&, const ShapeData&)>& visit) {
  for (const ShapeRecord& record : store.shapes()) {
    if (record.status == ShapeStatus::indexed) visit(record, store.data(record.id));
  }
}

}  // namespace

std::string models_to_csv(const VectorTable& vectors) {
  std::string csv = "id,path,scale\n";
  for (const StoredVector vector : vectors) {
    fmt::format_to(std::back_inserter(csv), "{},{},{}\n", vector.shape_id,
                   csv_field(std::string(vector.path)), vector.scale);
  }
  return csv;
}

std::string vectors_to_csv(const VectorTable& vectors) {
  if (vectors.empty()) return {};
  std::string csv = "id,path,scale";
  for (std::size_t i = 1; i <= vectors.dimension(); ++i) csv += fmt::format(",v{}", i);
  csv += '\n';
  for (const StoredVector vector : vectors) {
    fmt::format_to(std::back_inserter(csv), "{},{},{}", vector.shape_id,
                   csv_field(std::string(vector.path)), vector.scale);
    for (const float value : vector.values) csv += fmt::format(",{}", value);
    csv += '\n';
  }
  return csv;
}

std::string vectors_to_npy(const VectorTable& vectors) {
  std::string content =
      npy_header("'<f4'", fmt::format("{}, {}", vectors.size(), vectors.dimension()));
  for (const StoredVector vector : vectors) {
    append_bytes(encode_floats(vector.values), content);
  }
  return content;
}

std::string balls_to_csv(const ShapeStore& store) {
  std::string csv = "id,path,ball,x,y,z,r\n";
  for_each_indexed(store, [&](const ShapeRecord& record, const ShapeData& data) {
    std::size_t number = 0;
    for (const Ball& ball : data.balls) {
      fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{}\n", record.id,
                     csv_field(record.path), ++number, ball.center.x(), ball.center.y(),
                     ball.center.z(), ball.radius);
    }
  });
  return csv;
}

std::string balls_to_npy(const ShapeStore& store) {
  std::string records;
  std::size_t count = 0;
  for_each_indexed(store, [&](const ShapeRecord& record, const ShapeData& data) {
    for (const Ball& ball : data.balls) {
      append_little_endian(std::bit_cast<std::uint64_t>(record.id), 8, records);
      append_bytes(encode_balls(std::span(&ball, 1)), records);
      ++count;
    }
  });
  return npy_header("[('id', '<i8'), ('x', '<f8'), ('y', '<f8'), ('z', '<f8'), ('r', '<f8')]",
                    fmt::format("{},", count)) +
         records;
}

}  // namespace mdbd
