#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "store/sqlite_database.h"

/// Care of the SQLite database as a file, whatever is in it. Every function throws StoreError as
/// open_store_read_only() does.
namespace mdbd {

/// Copies a database to a new file while others use it (SQLite's online backup): the copy is of one
/// state, and there as a whole or not at all.
/// @throws StoreError also if there is something at the target, or it cannot be written
void backup_database(const std::filesystem::path& database, const std::filesystem::path& target);

/// What the pages of a database take: the size of its file once the log is copied into it, which
/// may take as much again while the database is in use.
struct DatabaseSize {
  std::uint64_t bytes = 0;
  std::uint64_t unused_bytes = 0;  ///< compact_database() gives them back
};

DatabaseSize database_size(const std::filesystem::path& database);

/// Writes a database anew without unused space. Others wait meanwhile.
/// @param busy_timeout how long to wait for others, readers among them
/// @throws StoreError also if it is in use for too long, or the disk is full
void compact_database(const std::filesystem::path& database,
                      std::chrono::milliseconds busy_timeout = default_busy_timeout);

/// Has SQLite check every page, index and reference.
/// @returns what is wrong, a line each, the last one why SQLite stopped if it had to; empty if
///          nothing is
std::vector<std::string> find_damage(const std::filesystem::path& database);

}  // namespace mdbd
