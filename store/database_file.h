#pragma once

#include <filesystem>
#include <optional>

#include "store/sqlite_database.h"

/// What can be told of a database file without asking SQLite, which takes a file of one byte for an
/// empty database, and one that ends within its last page for a whole one. Every function throws
/// StoreError with a message that says what to do.
namespace mdbd {

/// Whether there is something at a path; true if permissions hide it.
/// @throws StoreError if it is a folder or another thing than a file
bool find_database_file(const std::filesystem::path& path);

/// @throws StoreError if the path is empty or its folder does not exist
void require_folder_of(const std::filesystem::path& path);

/// Checks the header of a file that is not empty, and the length of the file against it. To be
/// called before any statement is run.
/// @throws StoreError if the file is no SQLite database or truncated
void require_whole_file(const Database& database);

/// The log with changes that are not in the database file yet, if there is one.
std::optional<std::filesystem::path> find_log(const std::filesystem::path& path);

}  // namespace mdbd
