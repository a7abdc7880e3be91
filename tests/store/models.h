#pragma once

#include <string>

#include "features/core/errors.h"
#include "store/shape_record.h"
#include "store/vector_table.h"

/// Made-up models whose data follows from a seed, so that a reader can check it.
namespace mdbd::test {

inline ShapeRecord make_record(const std::string& path, const std::string& hash = "00ff") {
  ShapeRecord record;
  record.path = path;
  record.content_hash = hash;
  record.file_size = 1234;
  record.modified_ns = 1'700'000'000'123'456'789;
  record.format = "off";
  record.representation = "mesh";
  record.statistics = R"({"faces":12})";
  record.scale = 1.5;
  record.seconds = 0.25;
  return record;
}

inline ShapeRecord make_failed_record(const std::string& path) {
  ShapeRecord record = make_record(path);
  record.status = ShapeStatus::failed;
  record.failure = FailureKind::content;
  record.reason = "no triangles";
  record.scale = 0.0;
  return record;
}

/// 100 and 30 numbers and as many balls as asked for, all different.
inline ShapeData make_data(int seed, int ball_count = 20) {
  ShapeData data;
  for (int i = 0; i < 100; ++i) data.signature.push_back(static_cast<float>(seed + i / 7.0));
  for (int i = 0; i < 30; ++i) data.fused.push_back(static_cast<float>(seed - i / 3.0));
  data.thumbnail = std::string("\x89PNG\0\xff", 6) + static_cast<char>(seed);
  for (int i = 0; i < ball_count; ++i) {
    data.balls.push_back({{seed + 1.0 / 3.0, i / 7.0, -1e-300 * i}, 1.0 / (seed + i + 1)});
  }
  return data;
}

inline bool is_same(const ShapeData& left, const ShapeData& right) {
  if (left.signature != right.signature || left.fused != right.fused ||
      left.thumbnail != right.thumbnail || left.balls.size() != right.balls.size()) {
    return false;
  }
  for (std::size_t i = 0; i < left.balls.size(); ++i) {
    const Ball& a = left.balls[i];
    const Ball& b = right.balls[i];
    if (a.center != b.center || a.radius != b.radius) return false;
  }
  return true;
}

inline std::vector<float> numbers(const StoredVector& vector) {
  return {vector.values.begin(), vector.values.end()};
}

/// What a StoreError says; empty if `action` throws none.
template <typename Action>
std::string store_error_of(const Action& action) {
  try {
    action();
    return {};
  } catch (const StoreError& error) {
    return error.what();
  }
}

}  // namespace mdbd::test
