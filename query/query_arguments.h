#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "collection/process_pool.h"
#include "query/answer_query.h"
#include "query/duplicates.h"

namespace CLI {
class App;
}

namespace mdbd {

/// The command line of mdbd-query.
struct QueryArguments {
  std::vector<std::filesystem::path> models;  ///< files and folders
  std::int64_t id = 0;                        ///< 0 if it is not given
  std::filesystem::path database;
  QueryOptions options;
  ProcessLimits limits;         ///< of the process that reads a model
  bool has_duplicates = false;  ///< asked for, in place of a query
  DuplicateOptions duplicates;
  bool has_no_surfaces = false;  ///< duplicates by signatures alone
  bool has_no_cache = false;
  bool is_explained = false;
  std::filesystem::path html;  ///< the page to write; empty: none
  bool is_json = false;
  bool is_csv = false;
};

/// Declares the options. What they mean together is known once they are parsed: see finish().
void declare_options(CLI::App& app, QueryArguments& arguments);

/// To be called after parsing: checks that there is something to do, and settles what depends on
/// several options.
/// @throws CLI::Error if there is not
void finish(const CLI::App& app, QueryArguments& arguments);

}  // namespace mdbd
