#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "features/core/ball.h"

namespace mdbd {

/// What became of a model.
enum class ShapeStatus { indexed, failed };

/// Why a model failed; decides whether the next run tries again.
enum class FailureKind {
  none,        ///< it did not
  content,     ///< the file is damaged or no solid; tried again when its content changes
  unreadable,  ///< the file could not be read; tried again at every run
  budget,      ///< time or memory exceeded; tried again on request
  crash        ///< a reader or the decomposition died; tried again on request
};

/// The names that the database and its readers use: "indexed", "content", …
std::string_view to_string(ShapeStatus status);
std::string_view to_string(FailureKind kind);

/// One model of a collection: a row of the table `shapes`.
struct ShapeRecord {
  std::int64_t id = 0;           ///< given by the store, never used again; 0 if not stored yet
  std::string path;              ///< absolute
  std::string content_hash;      ///< of the file's bytes, lower-case hexadecimal; may be empty
  std::uint64_t file_size = 0;   ///< bytes
  std::int64_t modified_ns = 0;  ///< modification time, nanoseconds since the epoch
  std::string format;            ///< "off", "obj", …
  std::string representation;    ///< "mesh"; empty if the file could not be read
  std::string statistics;        ///< a JSON object, or empty
  double scale = 0.0;            ///< R in object units; 0 if the model failed
  ShapeStatus status = ShapeStatus::indexed;
  FailureKind failure = FailureKind::none;
  std::string reason;           ///< why it failed, or why it has fewer balls; else empty
  bool walk_is_defined = true;  ///< see Descriptor
  double seconds = 0.0;         ///< what computing it took
  std::string indexed_at;       ///< UTC, ISO 8601; set by the store
};

/// What is computed from a model, beside its record.
struct ShapeData {
  std::vector<Ball> balls;       ///< in order of placement; object units
  std::vector<float> signature;  ///< the vector of signature mdbd-100
  std::vector<float> fused;      ///< the vector of signature mdbd-fused; empty if it is not there
  std::string thumbnail = {};    ///< a picture as a PNG file; empty if it is not there
};

}  // namespace mdbd
