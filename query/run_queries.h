#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "query/query_arguments.h"

namespace mdbd {

/// What became of the queries of a command line.
struct QueryRun {
  bool is_batch = false;              ///< several were asked for, or a folder
  std::vector<QueryAnswer> answers;   ///< ordered by path if it is a batch
  std::vector<std::string> failures;  ///< of a batch: what files could not be used, and why
};

/// Answers one query, or one for each model at and below the paths, with the collection read once.
/// In a batch a file that cannot be used does not keep the others from being answered.
/// @throws IoError if a path does not exist
/// @throws InvalidInput if the file of a single query cannot be used, or a batch has no models
/// @throws StoreError if the collection cannot be read
QueryRun run_queries(const ShapeStore& store, const QueryArguments& arguments);

/// All answers in the form that is asked for. Those of a batch name their query.
std::string format_answers(const QueryRun& run, const QueryArguments& arguments,
                           const std::filesystem::path& directory);

}  // namespace mdbd
