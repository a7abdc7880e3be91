#include "store/open_database.h"

#include <optional>
#include <string>

#include <sqlite3.h>

#include "store/database_file.h"
#include "store/sqlite_schema.h"

namespace mdbd {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw StoreError(path.string() + ": " + why);
}

}  // namespace

Database open_existing(const fs::path& path, Access access,
                       std::chrono::milliseconds busy_timeout) {
  if (!find_database_file(path)) {
    refuse(path, "there is no such database; make it with mdbd-index, or name another with --db");
  }
  Database database(path, access, busy_timeout);
  require_whole_file(database);
  require_readable_schema(database);
  return database;
}

// Even a reader of a database in write-ahead mode needs the files "-wal" and "-shm", which cannot
// be made in a read-only place. Where there is no log, everything is in the database file and
// nobody is writing it, so that it may be read as immutable, without them.
Database open_for_reading(const fs::path& path) {
  try {
    return open_existing(path, Access::read_only);
  } catch (const SqliteError& error) {
    if (error.code() != SQLITE_CANTOPEN && error.code() != SQLITE_READONLY) throw;
    if (const std::optional<fs::path> log = find_log(path)) {
      refuse(path, "has changes in " + log->string() +
                       ", which cannot be read in a read-only place; run mdbd-index on it where it "
                       "can be written, or copy both files to such a place");
    }
  }
  return open_existing(path, Access::immutable);
}

}  // namespace mdbd
