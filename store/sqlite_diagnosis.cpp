#include "store/sqlite_diagnosis.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <unistd.h>

namespace mdbd {
namespace {

std::filesystem::path folder_of(const std::filesystem::path& database) {
  return database.has_parent_path() ? database.parent_path() : ".";
}

// Of the effective user, as for open(); a read-only file system counts, too.
bool may(int right, const std::filesystem::path& path) {
  return faccessat(AT_FDCWD, path.c_str(), right, AT_EACCESS) == 0;
}

std::string explain_access(const std::filesystem::path& database, std::string_view message) {
  std::error_code error;
  if (std::filesystem::exists(database, error) && !may(R_OK, database)) {
    return database.string() + ": no permission to read it; ask for it, or use another --db";
  }
  if (!may(X_OK, folder_of(database))) {
    return database.string() +
           ": no permission to enter its folder; ask for it, or use another --db";
  }
  if (!may(W_OK, database) || !may(W_OK, folder_of(database))) return explain_read_only(database);
  return database.string() + ": cannot be opened (" + std::string(message) + "); use another --db";
}

}  // namespace

std::string explain_failure(int code, const std::filesystem::path& database,
                            std::string_view sqlite_message) {
  const std::string path = database.string();
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return path + ": database is locked by another process; try again when that has finished";
    case SQLITE_NOTADB:
      return path + ": its header is damaged, or it is encrypted; name another file with --db";
    case SQLITE_FULL:
      return path + ": the disk is full; make room and try again, or use another --db";
    case SQLITE_CANTOPEN:
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return explain_access(database, sqlite_message);
    case SQLITE_IOERR:
      return path + ": reading or writing failed (" + std::string(sqlite_message) +
             "); check the disk, or use another --db";
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:  // a table or column is missing
      return explain_damage(database, sqlite_message);
    default:
      return path + ": " + std::string(sqlite_message);
  }
}

std::string explain_damage(const std::filesystem::path& database, std::string_view what) {
  return database.string() + ": damaged (" + std::string(what) +
         "); restore it from a copy, or remove it and index again";
}

std::string explain_read_only(const std::filesystem::path& database) {
  std::error_code error;
  const bool is_file_to_blame = std::filesystem::exists(database, error) && !may(W_OK, database);
  return database.string() + ": cannot be written, " +
         (is_file_to_blame ? "the file" : "the folder " + folder_of(database).string()) +
         " is read-only; make it writable, or use another --db";
}

}  // namespace mdbd
