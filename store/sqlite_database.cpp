#include "store/sqlite_database.h"

#include <sqlite3.h>

#include "store/sqlite_diagnosis.h"

namespace mdbd {
namespace {

// SQLite gives "", ":memory:" and "file:…" meanings of their own; an absolute path has none.
std::string absolute_name(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  return error ? path.string() : absolute.string();
}

std::string immutable_uri(const std::string& name) {
  std::string uri = "file://";
  for (const char c : name) {
    if (c == '%') {
      uri += "%25";
    } else if (c == '?') {
      uri += "%3f";
    } else if (c == '#') {
      uri += "%23";
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

// Reading, too, opens the file for writing if it can: the last connection that may write removes
// the files "-wal" and "-shm" again, one opened with SQLITE_OPEN_READONLY leaves them behind.
int open_flags(Access access) {
  switch (access) {
    case Access::read_write:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    case Access::read_only:
      return SQLITE_OPEN_READWRITE;
    case Access::immutable:
      return SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
  }
  return 0;
}

// Whether a copy failed by what was read, not by what was written.
bool is_failure_of_source(int code) {
  switch (code) {
    case SQLITE_IOERR_READ:
    case SQLITE_IOERR_SHORT_READ:
    case SQLITE_IOERR_CORRUPTFS:
      return true;
    default:
      return (code & 0xff) == SQLITE_CORRUPT || (code & 0xff) == SQLITE_NOTADB;
  }
}

}  // namespace

void Database::Closer::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

Database::Database(const std::filesystem::path& path, Access access,
                   std::chrono::milliseconds busy_timeout)
    : path_(path) {
  std::string name = absolute_name(path);
  if (access == Access::immutable) name = immutable_uri(name);
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &handle, open_flags(access), nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) fail(code);
  sqlite3_busy_timeout(handle, static_cast<int>(busy_timeout.count()));
  // The file may come from anywhere: its schema must not run functions, its cells are checked.
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  execute("PRAGMA foreign_keys = ON; PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON");
  if (access != Access::read_write) execute("PRAGMA query_only = ON");
}

bool Database::is_read_only() const { return sqlite3_db_readonly(handle_.get(), "main") == 1; }

bool Database::has_moved() const {
  int moved = 0;
  const int code = sqlite3_file_control(handle_.get(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  if (code != SQLITE_OK) fail(code);
  return moved != 0;
}

std::string Database::read_header(int size) const {
  sqlite3_file* file = nullptr;
  int code = sqlite3_file_control(handle_.get(), "main", SQLITE_FCNTL_FILE_POINTER, &file);
  if (code != SQLITE_OK) fail(code);
  std::string header(static_cast<std::size_t>(size), '\0');
  code = file->pMethods->xRead(file, header.data(), size, 0);
  if (code != SQLITE_OK && code != SQLITE_IOERR_SHORT_READ) fail(code);
  return header;
}

int Database::changes() const { return sqlite3_changes(handle_.get()); }

void Database::back_up_to(const Database& target) const {
  sqlite3_backup* backup = sqlite3_backup_init(target.handle_.get(), "main", handle_.get(), "main");
  if (backup == nullptr) target.fail(sqlite3_extended_errcode(target.handle_.get()));
  const int code = sqlite3_backup_step(backup, -1);  // all pages at once: no writer comes between
  sqlite3_backup_finish(backup);
  if (code != SQLITE_DONE) (is_failure_of_source(code) ? *this : target).fail(code);
}

void Database::execute(const std::string& sql) const {
  const int code = sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

void Database::fail(int code) const {
  // SQLite's words on the connection's last error say more, if it is this one.
  const bool is_last = handle_ && sqlite3_errcode(handle_.get()) == (code & 0xff);
  const char* message = is_last ? sqlite3_errmsg(handle_.get()) : sqlite3_errstr(code);
  throw SqliteError(code & 0xff, explain_failure(code, path_, message));
}

void Statement::Finalizer::operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }

Statement::Statement(const Database& database, std::string_view sql) : database_(database) {
  sqlite3_stmt* handle = nullptr;
  check(sqlite3_prepare_v2(database.handle_.get(), sql.data(), static_cast<int>(sql.size()),
                           &handle, nullptr));
  handle_.reset(handle);
}

bool Statement::step() {
  const int code = sqlite3_step(handle_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) database_.fail(code);
  return code == SQLITE_ROW;
}

void Statement::run() {
  while (step()) {
  }
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(handle_.get(), column);
}

double Statement::real(int column) const { return sqlite3_column_double(handle_.get(), column); }

std::string Statement::text(int column) const {
  const auto* data = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
  if (data == nullptr) return {};
  return {data, static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

std::span<const std::byte> Statement::bytes(int column) const {
  const auto* data = static_cast<const std::byte*>(sqlite3_column_blob(handle_.get(), column));
  if (data == nullptr) return {};
  return {data, static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

void Statement::bind_next(std::int64_t value) {
  check(sqlite3_bind_int64(handle_.get(), ++bound_, value));
}

void Statement::bind_next(double value) {
  check(sqlite3_bind_double(handle_.get(), ++bound_, value));
}

// A null pointer would bind NULL, so that what is empty needs an address.
void Statement::bind_next(std::string_view value) {
  const char* data = value.empty() ? "" : value.data();
  check(sqlite3_bind_text64(handle_.get(), ++bound_, data, value.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8));
}

void Statement::bind_next(std::span<const std::byte> value) {
  const void* data = value.empty() ? static_cast<const void*>("") : value.data();
  check(sqlite3_bind_blob64(handle_.get(), ++bound_, data, value.size(), SQLITE_TRANSIENT));
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) database_.fail(code);
}

Transaction::Transaction(const Database& database, Kind kind) : database_(database) {
  database.execute(kind == Kind::writing ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  // It fails only if SQLite has rolled back by itself already, after a full disk for example.
  if (is_open_) sqlite3_exec(database_.handle_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.execute("COMMIT");
  is_open_ = false;
}

}  // namespace mdbd
