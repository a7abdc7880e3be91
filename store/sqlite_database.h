#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "features/core/errors.h"

struct sqlite3;
struct sqlite3_stmt;

/// RAII over the C interface of SQLite. None of it is thread-safe. Destructors never throw.
/// A connection is a handle: const functions may change what is in the database.
namespace mdbd {

/// A StoreError that carries SQLite's result code.
class SqliteError : public StoreError {
 public:
  SqliteError(int code, const std::string& message) : StoreError(message), code_(code) {}
  int code() const { return code_; }  ///< primary result code, such as SQLITE_BUSY

 private:
  int code_;
};

inline constexpr std::chrono::seconds default_busy_timeout{10};

enum class Access {
  read_write,  ///< created if missing
  read_only,   ///< never created; no statement changes it
  immutable    ///< read-only without any locking: nobody may write meanwhile
};

/// A connection to the database in a file. Foreign keys are enforced.
class Database {
 public:
  /// @param busy_timeout how long a statement waits for locks of other processes
  /// @throws SqliteError, as all functions here, with a message that names the path
  Database(const std::filesystem::path& path, Access access,
           std::chrono::milliseconds busy_timeout = default_busy_timeout);

  const std::filesystem::path& path() const { return path_; }
  /// Whether the file could be opened for reading only, although writing was asked for.
  bool is_read_only() const;
  /// Whether something else, or nothing, lies at the path now: the file was moved, replaced or
  /// removed, and what is written to it is lost.
  bool has_moved() const;
  /// The first bytes of the file, filled up with zeros. They are read through SQLite's own file
  /// handle: to open and close the file once more would drop the locks of this process.
  std::string read_header(int size) const;
  /// Rows changed by the last statement that changed any.
  int changes() const;
  /// Makes another database a copy of this one, of one state, while others may use this one.
  void back_up_to(const Database& target) const;
  /// Runs one or more statements and drops their rows.
  void execute(const std::string& sql) const;

 private:
  friend class Statement;
  friend class Transaction;
  struct Closer {
    void operator()(sqlite3* handle) const;
  };
  [[noreturn]] void fail(int code) const;

  std::filesystem::path path_;
  std::unique_ptr<sqlite3, Closer> handle_;
};

/// A prepared statement; must not outlive its database.
class Statement {
 public:
  Statement(const Database& database, std::string_view sql);

  /// Binds the next parameters, in order; texts and bytes are copied.
  template <typename... Values>
  Statement& bind(const Values&... values) {
    (bind_next(values), ...);
    return *this;
  }

  /// Goes to the next row. @returns whether there is one
  bool step();
  /// Runs to the end.
  void run();

  /// Columns of the row, from 0; NULL reads as 0 or empty. Bytes are valid until the next step.
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;
  std::span<const std::byte> bytes(int column) const;

 private:
  struct Finalizer {
    void operator()(sqlite3_stmt* handle) const;
  };
  void bind_next(std::int64_t value);
  void bind_next(double value);
  void bind_next(std::string_view value);
  void bind_next(std::span<const std::byte> value);
  void check(int code) const;

  const Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalizer> handle_;
  int bound_ = 0;
};

/// A transaction, rolled back at the end of the scope unless committed.
class Transaction {
 public:
  enum class Kind {
    reading,  ///< everything read comes from one state of the database
    writing   ///< waits for other writers at once, not at the first change
  };
  Transaction(const Database& database, Kind kind);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();

 private:
  const Database& database_;
  bool is_open_ = true;
};

}  // namespace mdbd
