#pragma once

#include <chrono>
#include <filesystem>

#include "store/sqlite_database.h"

/// Connections to databases that exist. Every function throws StoreError as open_store_read_only()
/// does.
namespace mdbd {

/// Opens a database for reading, in a read-only place, too, where nobody may write it meanwhile.
Database open_for_reading(const std::filesystem::path& path);

/// Opens a database as it is.
Database open_existing(const std::filesystem::path& path, Access access,
                       std::chrono::milliseconds busy_timeout = default_busy_timeout);

}  // namespace mdbd
