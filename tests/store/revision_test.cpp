#include <set>

#include <catch2/catch.hpp>

#include "store/maintenance.h"
#include "store/shape_store.h"
#include "store/sqlite_database.h"
#include "tests/store/models.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("every change of a vector, a path or a scale gives another revision") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const auto reader = open_store_read_only(folder / "a.db");
  std::set<std::string> seen = {store->revision()};
  CHECK_FALSE(store->revision().empty());
  const auto check_new = [&] {
    CHECK(seen.insert(store->revision()).second);
    CHECK(reader->revision() == store->revision());
  };
  const std::int64_t id = store->put(make_record("/a.off"), make_data(1));
  check_new();
  store->put(make_record("/a.off"), make_data(1));
  check_new();
  store->put_vector(id, "esf", std::vector{1.0F});
  check_new();
  store->put_vector(id, "esf", std::vector{1.0F});
  check_new();
  store->move(id, "/b.off", 1);
  check_new();
  store->put(make_failed_record("/b.off"), {});
  check_new();
  const std::int64_t other = store->put(make_record("/c.off"), make_data(2));
  check_new();
  store->remove(other);
  check_new();
}

TEST_CASE("what leaves the vectors alone leaves the revision") {
  const TemporaryDirectory folder;
  std::string revision;
  {
    const auto store = open_store(folder / "a.db");
    const std::int64_t id = store->put(make_record("/a.off"), make_data(1));
    revision = store->revision();
    store->touch(id, 7, 8);
    store->put(make_failed_record("/b.off"), {});
    CHECK(store->revision() == revision);
  }
  compact_database(folder / "a.db");
  CHECK(open_store(folder / "a.db")->revision() == revision);
}

TEST_CASE("a copy has the revision of its original until one of them changes") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  store->put(make_record("/a.off"), make_data(1));
  backup_database(folder / "a.db", folder / "b.db");
  const auto copy = open_store(folder / "b.db");
  CHECK(copy->revision() == store->revision());
  copy->put(make_record("/b.off"), make_data(2));
  store->put(make_record("/b.off"), make_data(2));
  CHECK(copy->revision() != store->revision());
}

TEST_CASE("changes by other programs give another revision, too") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  store->put(make_record("/a.off"), make_data(1));
  const std::string sql =
      GENERATE("DELETE FROM vectors", "PRAGMA foreign_keys = OFF; DELETE FROM shapes",
               "UPDATE shapes SET scale = 2", "UPDATE vectors SET \"values\" = x'00'");
  const std::string revision = store->revision();
  Database(folder / "a.db", Access::read_write).execute(sql);
  CHECK(store->revision() != revision);
}
