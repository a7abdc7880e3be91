#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <unordered_set>

#include "features/describe.h"
#include "indexer/process_pool.h"
#include "store/shape_record.h"

namespace mdbd {

/// Computes what the store keeps of a file; throws as describe_file() does.
using DescribeFunction = std::function<ShapeDescription(const std::filesystem::path&)>;

/// What became of one file. The fields of the record that belong to the file and not to its content
/// are empty: id, path, file_size, modified_ns, indexed_at.
struct ModelResult {
  bool is_known = false;  ///< nothing was computed: the content is among the known ones
  ShapeRecord record;     ///< indexed or failed; only the hash is set if is_known
  ShapeData data;
};

/// The work of a job: hashes a file and, unless its content is among `known_hashes`, computes its
/// description; sends both, the hash first, so that it is there even if the rest is not.
/// What fails becomes part of the result; only std::bad_alloc is thrown.
void run_model_job(const std::filesystem::path& path,
                   const std::unordered_set<std::string>& known_hashes,
                   const DescribeFunction& describe, const SendOutput& send);

/// The result of a job that ran run_model_job, however it ended.
ModelResult read_model_result(const ProcessOutcome& outcome);

}  // namespace mdbd
