#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <unordered_set>

#include "collection/process_pool.h"
#include "features/describe.h"
#include "store/shape_record.h"

namespace mdbd {

/// Computes what the store keeps of a file; throws as describe_file() does.
using DescribeFunction = std::function<ShapeDescription(const std::filesystem::path&)>;

/// describe_file(), with a picture of the shape.
ShapeDescription describe_with_thumbnail(const std::filesystem::path& path, const Recipe& recipe);

/// What the result of a file depends on: its content, and its ending, which says how to read it.
std::string content_key(const std::string& content_hash, const std::filesystem::path& path);

/// What became of one file, or solid. The fields of the record that belong to the file and not to
/// its content are empty: id, path, file_size, modified_ns, indexed_at.
struct ModelResult {
  bool is_known = false;  ///< nothing was computed: the content is among the known ones
  /// Above 1 if nothing was computed since each solid of the file is to be a model.
  std::size_t solids = 1;
  ShapeRecord record;  ///< indexed or failed; only the hash is set if nothing was computed
  ShapeData data;
};

/// The work of a job: hashes a file and, unless its key is among `known_keys`, computes its
/// description; sends both, the hash first, so that it is there even if the rest is not.
/// What fails becomes part of the result; only std::bad_alloc is thrown.
/// @param path of a file, or of one solid of it
/// @param is_per_solid of a CAD file of several solids they are counted, and no more
void run_model_job(const std::filesystem::path& path,
                   const std::unordered_set<std::string>& known_keys,
                   const DescribeFunction& describe, const SendOutput& send,
                   bool is_per_solid = false);

/// The result of a job that ran run_model_job, however it ended.
ModelResult read_model_result(const ProcessOutcome& outcome);

}  // namespace mdbd
