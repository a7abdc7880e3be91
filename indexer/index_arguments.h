#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "indexer/indexer.h"
#include "indexer/open_index_store.h"

namespace CLI {
class App;
}

namespace mdbd {

/// The command line of mdbd-index.
struct IndexArguments {
  std::vector<std::filesystem::path> paths;
  std::filesystem::path database;
  RecipeOverrides recipe;
  IndexOptions options;
  std::string unit;  ///< of files whose format has none; empty if it is not declared
  bool has_no_thumbnails = false;
  bool is_dry_run = false;
  bool is_watching = false;
  std::chrono::duration<double> rescan = std::chrono::minutes(1);
  bool is_json = false;
  bool is_quiet = false;
};

/// Declares the options of mdbd-index and its help.
void declare_options(CLI::App& app, IndexArguments& arguments);

}  // namespace mdbd
