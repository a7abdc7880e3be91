#include "store/maintenance.h"

#include <system_error>

#include "features/core/errors.h"
#include "store/database_file.h"
#include "store/open_database.h"
#include "store/sqlite_database.h"
#include "store/sqlite_diagnosis.h"

namespace mdbd {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw StoreError(path.string() + ": " + why);
}

std::int64_t query_integer(const Database& database, std::string_view sql) {
  Statement statement(database, sql);
  statement.step();
  return statement.integer(0);
}

void check_pages(const Database& database, std::vector<std::string>& damage) {
  Statement integrity(database, "PRAGMA integrity_check");
  while (integrity.step()) {
    if (integrity.text(0) != "ok") damage.push_back(integrity.text(0));
  }
}

void check_references(const Database& database, std::vector<std::string>& damage) {
  Statement references(database, "PRAGMA foreign_key_check");
  while (references.step()) {
    damage.push_back("a row of the table " + references.text(0) + " belongs to no model");
  }
}

/// A file that is removed unless it is kept.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(fs::path path) : path_(std::move(path)) { remove(); }
  ~UnfinishedFile() { remove(); }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  const fs::path& path() const { return path_; }

  void rename_to(const fs::path& target) {
    std::error_code error;
    fs::rename(path_, target, error);
    if (error) refuse(target, "cannot be written: " + error.message());
  }

 private:
  void remove() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }

  fs::path path_;
};

}  // namespace

void backup_database(const fs::path& database, const fs::path& target) {
  const Database source = open_for_reading(database);
  if (find_database_file(target)) refuse(target, "is there already; name a new file");
  require_folder_of(target);
  UnfinishedFile copy(fs::path(target) += ".unfinished");
  {
    const Database destination(copy.path(), Access::read_write);
    source.back_up_to(destination);
  }
  copy.rename_to(target);
}

DatabaseSize database_size(const fs::path& path) {
  const Database database = open_for_reading(path);
  const Transaction reading(database, Transaction::Kind::reading);
  const auto page = static_cast<std::uint64_t>(query_integer(database, "PRAGMA page_size"));
  const auto pages = static_cast<std::uint64_t>(query_integer(database, "PRAGMA page_count"));
  const auto unused = static_cast<std::uint64_t>(query_integer(database, "PRAGMA freelist_count"));
  return {.bytes = page * pages, .unused_bytes = page * unused};
}

void compact_database(const fs::path& path, std::chrono::milliseconds busy_timeout) {
  const Database database = open_existing(path, Access::read_write, busy_timeout);
  if (database.is_read_only()) throw StoreError(explain_read_only(path));
  database.execute("VACUUM");
  // In write-ahead mode the file itself shrinks when the log is copied into it.
  if (query_integer(database, "PRAGMA wal_checkpoint(TRUNCATE)") != 0) {
    refuse(path, "in use, so that its file cannot shrink yet; try again when nothing else uses it");
  }
}

std::vector<std::string> find_damage(const fs::path& path) {
  const Database database = open_for_reading(path);
  const Transaction reading(database, Transaction::Kind::reading);
  std::vector<std::string> damage;
  try {
    check_pages(database, damage);
    check_references(database, damage);
  } catch (const SqliteError& error) {
    damage.emplace_back(error.what());
  }
  return damage;
}

}  // namespace mdbd
