#include "store/sqlite_database.h"

#include <stdexcept>

#include <catch2/catch.hpp>
#include <sqlite3.h>

#include "tests/store/models.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

std::int64_t count_rows(const Database& database) {
  Statement statement(database, "SELECT count(*) FROM t");
  statement.step();
  return statement.integer(0);
}

Database make_database(const std::filesystem::path& path) {
  Database database(path, Access::read_write);
  database.execute("CREATE TABLE t (x)");
  return database;
}

}  // namespace

TEST_CASE("values come back as they were bound") {
  const TemporaryDirectory folder;
  const Database database = make_database(folder / "a.db");
  const std::vector<std::byte> bytes = {std::byte{0}, std::byte{255}};
  Statement row(database, "SELECT ?, ?, ?, ?, ?");
  row.bind(std::int64_t{-7}, 0.1, std::string_view("ä\0b", 4), std::span(bytes),
           std::string_view());
  REQUIRE(row.step());
  CHECK(row.integer(0) == -7);
  CHECK(row.real(1) == 0.1);
  CHECK(row.text(2) == std::string("ä\0b", 4));
  CHECK(std::vector(row.bytes(3).begin(), row.bytes(3).end()) == bytes);
  CHECK(row.text(4).empty());
  CHECK_FALSE(row.step());
}

TEST_CASE("what is empty is not NULL") {
  const TemporaryDirectory folder;
  const Database database = make_database(folder / "a.db");
  Statement row(database, "SELECT typeof(?), typeof(?)");
  row.bind(std::string_view(), std::span<const std::byte>());
  REQUIRE(row.step());
  CHECK(row.text(0) == "text");
  CHECK(row.text(1) == "blob");
}

TEST_CASE("a transaction is kept when it is committed, rolled back otherwise") {
  const TemporaryDirectory folder;
  const Database database = make_database(folder / "a.db");
  SECTION("committed") {
    Transaction transaction(database, Transaction::Kind::writing);
    database.execute("INSERT INTO t VALUES (1)");
    transaction.commit();
    CHECK(count_rows(database) == 1);
  }
  SECTION("end of scope") {
    {
      const Transaction transaction(database, Transaction::Kind::writing);
      database.execute("INSERT INTO t VALUES (1)");
    }
    CHECK(count_rows(database) == 0);
  }
  SECTION("exception") {
    const auto fail = [&] {
      const Transaction transaction(database, Transaction::Kind::writing);
      database.execute("INSERT INTO t VALUES (1)");
      throw std::logic_error("in between");
    };
    CHECK_THROWS_AS(fail(), std::logic_error);
    CHECK(count_rows(database) == 0);
  }
  SECTION("after a failed statement the next transaction works") {
    const auto fail = [&] {
      const Transaction transaction(database, Transaction::Kind::writing);
      database.execute("INSERT INTO t VALUES (1)");
      database.execute("INSERT INTO nowhere VALUES (1)");
    };
    CHECK_THROWS_AS(fail(), SqliteError);
    Transaction transaction(database, Transaction::Kind::writing);
    database.execute("INSERT INTO t VALUES (2)");
    transaction.commit();
    CHECK(count_rows(database) == 1);
  }
}

TEST_CASE("errors name the database and carry SQLite's code and words") {
  const TemporaryDirectory folder;
  const Database database = make_database(folder / "a.db");
  try {
    const Statement statement(database, "SELECT x FROM nowhere");
    FAIL("no error");
  } catch (const SqliteError& error) {
    CHECK(error.code() == SQLITE_ERROR);
    CHECK_THAT(error.what(), StartsWith((folder / "a.db").string()) && Contains("nowhere"));
  }
}

TEST_CASE("a copy that fails by what is read names the database that is read") {
  const TemporaryDirectory folder;
  const Database source(folder.write("source.db", std::string(10'000, 'S')), Access::read_only);
  const Database target(folder / "target.db", Access::read_write);
  CHECK_THAT(store_error_of([&] { source.back_up_to(target); }),
             StartsWith((folder / "source.db").string() + ": its header is damaged"));
}

TEST_CASE("a lock that is not released is named") {
  const TemporaryDirectory folder;
  const Database first = make_database(folder / "a.db");
  const Transaction holding(first, Transaction::Kind::writing);
  const Database second(folder / "a.db", Access::read_write, std::chrono::milliseconds(20));
  const std::string message =
      store_error_of([&] { const Transaction waiting(second, Transaction::Kind::writing); });
  CHECK_THAT(message, StartsWith((folder / "a.db").string()) &&
                          Contains("database is locked by another process"));
}

TEST_CASE("names that mean something to SQLite are names of files") {
  const TemporaryDirectory folder;
  for (const char* name : {"a?mode=memory", "50%25#b", "file:c"}) {
    make_database(folder / name).execute("INSERT INTO t VALUES (1)");
    REQUIRE(std::filesystem::is_regular_file(folder / name));
    CHECK(count_rows(Database(folder / name, Access::immutable)) == 1);
  }
}

TEST_CASE("a database opened for reading refuses changes") {
  const TemporaryDirectory folder;
  make_database(folder / "a.db");
  const Access access = GENERATE(Access::read_only, Access::immutable);
  const Database database(folder / "a.db", access);
  CHECK_THROWS_AS(database.execute("INSERT INTO t VALUES (1)"), SqliteError);
  CHECK(count_rows(database) == 0);
}

TEST_CASE("a full disk is named, and what was there before stays") {
  const TemporaryDirectory folder;
  const Database database = make_database(folder / "a.db");
  database.execute("INSERT INTO t VALUES (1); PRAGMA max_page_count = 3");
  CHECK_THAT(store_error_of([&] { database.execute("INSERT INTO t VALUES (zeroblob(100000))"); }),
             StartsWith((folder / "a.db").string()) && Contains("the disk is full; make room"));
  CHECK(count_rows(database) == 1);
}
