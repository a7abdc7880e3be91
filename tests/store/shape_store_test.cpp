#include "store/shape_store.h"

#include <cmath>
#include <limits>
#include <regex>

#include <catch2/catch.hpp>

#include "store/sqlite_database.h"
#include "tests/store/models.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;
using Catch::Matchers::Contains;

namespace {

std::int64_t count_rows(const std::filesystem::path& path, const std::string& table) {
  const Database database(path, Access::read_only);
  Statement statement(database, "SELECT count(*) FROM " + table);
  statement.step();
  return statement.integer(0);
}

std::vector<std::string> paths_of(const std::vector<ShapeRecord>& records) {
  std::vector<std::string> paths;
  paths.reserve(records.size());
  for (const ShapeRecord& record : records) paths.push_back(record.path);
  return paths;
}

using Paths = std::vector<std::string>;

}  // namespace

TEST_CASE("a model comes back to the bit after reopening") {
  const TemporaryDirectory folder;
  ShapeRecord record = make_record("/models/ä name\n.off");
  record.file_size = std::numeric_limits<std::uint64_t>::max();
  record.modified_ns = -5;
  record.scale = 1.0 / 3.0;
  record.reason = "minimum radius reached";
  record.walk_is_defined = false;
  ShapeData data = make_data(3, 500);
  data.signature[7] = std::numeric_limits<float>::denorm_min();
  data.balls[9].center.x() = -std::numeric_limits<double>::max();
  const std::int64_t id = open_store(folder / "a.db")->put(record, data);

  const auto store = open_store(folder / "a.db");
  const std::optional<ShapeRecord> read = store->find(id);
  REQUIRE(read);
  CHECK(read->id == id);
  CHECK(read->path == record.path);
  CHECK(read->content_hash == record.content_hash);
  CHECK(read->file_size == record.file_size);
  CHECK(read->modified_ns == record.modified_ns);
  CHECK(read->format == record.format);
  CHECK(read->representation == record.representation);
  CHECK(read->statistics == record.statistics);
  CHECK(read->scale == record.scale);
  CHECK(read->status == ShapeStatus::indexed);
  CHECK(read->failure == FailureKind::none);
  CHECK(read->reason == record.reason);
  CHECK_FALSE(read->walk_is_defined);
  CHECK(read->seconds == record.seconds);
  CHECK(std::regex_match(read->indexed_at, std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
  CHECK(is_same(store->data(id), data));
}

TEST_CASE("a path that is no UTF-8 comes back byte by byte") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::string path = "/models/\xff\xfe.off";
  const std::int64_t id = store->put(make_record(path), make_data(1));
  CHECK(store->find(id)->path == path);
  CHECK(store->find_by_path(path)->id == id);
}

TEST_CASE("put replaces what is stored for a path and keeps its id") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = store->put(make_record("/a.off"), make_data(1, 20));
  const std::int64_t other = store->put(make_record("/b.off"), make_data(2, 20));
  CHECK(id != other);
  CHECK(store->put(make_record("/a.off", "new"), make_data(5, 3)) == id);
  CHECK(store->find(id)->content_hash == "new");
  CHECK(is_same(store->data(id), make_data(5, 3)));
  CHECK(is_same(store->data(other), make_data(2, 20)));
  CHECK(store->shapes().size() == 2);
}

TEST_CASE("ids are never used again") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = store->put(make_record("/a.off"), make_data(1));
  store->remove(id);
  CHECK(store->put(make_record("/a.off"), make_data(1)) > id);
}

TEST_CASE("a failed model has no data, whatever it had before") {
  const TemporaryDirectory folder;
  const FailureKind kind = GENERATE(FailureKind::content, FailureKind::unreadable,
                                    FailureKind::budget, FailureKind::crash);
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = store->put(make_record("/a.off"), make_data(1));
  ShapeRecord failed = make_failed_record("/a.off");
  failed.failure = kind;
  CHECK(store->put(failed, make_data(1)) == id);
  CHECK(store->find(id)->status == ShapeStatus::failed);
  CHECK(store->find(id)->failure == kind);
  CHECK(store->find(id)->reason == failed.reason);
  CHECK(store->data(id).signature.empty());
  CHECK(store->data(id).balls.empty());
  CHECK(store->vectors(signature_mdbd_100).empty());
  CHECK(count_rows(folder / "a.db", "vectors") == 0);
  CHECK(count_rows(folder / "a.db", "balls") == 0);
}

TEST_CASE("what does not fit is refused and changes nothing") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = store->put(make_record("/a.off"), make_data(1));
  ShapeRecord record = make_record("/a.off", "new");
  ShapeData data = make_data(2);
  SECTION("vector not finite") { data.signature[99] = std::nanf(""); }
  SECTION("vector too long") { data.signature.push_back(0.0F); }
  SECTION("vector missing") { data.signature.clear(); }
  SECTION("further vector not finite") { data.fused[2] = std::nanf(""); }
  SECTION("center not finite") { data.balls[3].center.z() = HUGE_VAL; }
  SECTION("radius not finite") { data.balls[3].radius = std::nan(""); }
  SECTION("scale not finite") { record.scale = std::nan(""); }
  SECTION("failed without a kind") { record.status = ShapeStatus::failed; }
  SECTION("indexed with a failure") { record.failure = FailureKind::crash; }
  CHECK_THAT(store_error_of([&] { store->put(record, data); }),
             Contains("a.db: /a.off cannot be stored"));
  CHECK(store->find(id)->content_hash == "00ff");
  CHECK(is_same(store->data(id), make_data(1)));
}

TEST_CASE("records are found by path and by content, ordered by path") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  store->put(make_record("/c.off", "same"), make_data(3));
  store->put(make_record("/a.off", "same"), make_data(1));
  store->put(make_record("/b.off", ""), make_data(2));
  CHECK(paths_of(store->shapes()) == Paths{"/a.off", "/b.off", "/c.off"});
  CHECK(paths_of(store->find_by_hash("same")) == Paths{"/a.off", "/c.off"});
  CHECK(store->find_by_hash("other").empty());
  CHECK(store->find_by_hash("").empty());
  CHECK(store->find_by_path("/b.off")->path == "/b.off");
  CHECK_FALSE(store->find_by_path("/B.off"));
  CHECK_FALSE(store->find(99));
}

TEST_CASE("vectors are those of indexed models, ordered by path") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t b = store->put(make_record("/b.off"), make_data(2));
  store->put(make_failed_record("/f.off"), {});
  const std::int64_t a = store->put(make_record("/a.off"), make_data(1));
  const VectorTable vectors = store->vectors(signature_mdbd_100);
  REQUIRE(vectors.size() == 2);
  CHECK(vectors[0].shape_id == a);
  CHECK(vectors[0].path == "/a.off");
  CHECK(vectors[0].scale == 1.5);
  CHECK(numbers(vectors[0]) == make_data(1).signature);
  CHECK(vectors[1].shape_id == b);
  CHECK(numbers(vectors[1]) == make_data(2).signature);
  CHECK(store->vectors("another").empty());
}

TEST_CASE("models without a signature are named until they have it") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  ShapeData without = make_data(2);
  without.fused.clear();
  const std::int64_t b = store->put(make_record("/b.off"), without);
  store->put(make_failed_record("/f.off"), {});
  const std::int64_t a = store->put(make_record("/a.off"), without);
  const std::int64_t c = store->put(make_record("/c.off"), make_data(1));
  CHECK(store->shapes_without(stored_mdbd_fused) == std::vector{a, b});
  CHECK(store->shapes_without("another") == std::vector{a, b, c});
  CHECK(store->shapes_without(signature_mdbd_100).empty());
  store->put_vector(a, stored_mdbd_fused, make_data(7).fused);
  CHECK(store->shapes_without(stored_mdbd_fused) == std::vector{b});
  CHECK(store->data(a).fused == make_data(7).fused);
  CHECK(store->data(b).fused.empty());
}

TEST_CASE("a signature takes the place of the one of another number, and of no other") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t a = store->put(make_record("/a.off"), make_data(1));
  const std::int64_t b = store->put(make_record("/b.off"), make_data(2));
  const std::vector<float> values{1, 2, 3};
  for (const char* name : {"new/1", "newer/1", "new"}) store->put_vector(a, name, values);
  store->put_vector(b, "new/1", values);
  store->put_vector(a, "new/2", values);
  CHECK(store->vectors("new/2").size() == 1);
  REQUIRE(store->vectors("new/1").size() == 1);
  CHECK(store->vectors("new/1")[0].shape_id == b);
  for (const char* name : {"newer/1", "new"}) CHECK(store->vectors(name).size() == 1);
  CHECK(store->data(a).fused == make_data(1).fused);
  CHECK(store->data(a).signature == make_data(1).signature);
}

TEST_CASE("touch changes size and time only") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = store->put(make_record("/a.off"), make_data(1));
  store->touch(id, 77, 88);
  CHECK(store->find(id)->file_size == 77);
  CHECK(store->find(id)->modified_ns == 88);
  CHECK(store->find(id)->content_hash == "00ff");
  CHECK(is_same(store->data(id), make_data(1)));
}

TEST_CASE("move changes path and time only, and replaces what was there") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = store->put(make_record("/a.off"), make_data(1));
  const std::int64_t target = store->put(make_record("/b.off"), make_data(2));
  store->move(id, "/b.off", 88);
  CHECK(paths_of(store->shapes()) == Paths{"/b.off"});
  CHECK(store->find_by_path("/b.off")->id == id);
  CHECK(store->find(id)->modified_ns == 88);
  CHECK_FALSE(store->find(target));
  CHECK(is_same(store->data(id), make_data(1)));
  store->move(id, "/b.off", 99);
  CHECK(store->find(id)->modified_ns == 99);
}

TEST_CASE("remove takes vectors and balls along") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = store->put(make_record("/a.off"), make_data(1));
  store->put(make_record("/b.off"), make_data(2));
  store->remove(id);
  store->remove(id);
  CHECK(paths_of(store->shapes()) == Paths{"/b.off"});
  CHECK(count_rows(folder / "a.db", "vectors") == 2);
  CHECK(count_rows(folder / "a.db", "balls") == 1);
}

TEST_CASE("a model that is not there is named") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  store->put(make_record("/a.off"), make_data(1));
  CHECK_THAT(store_error_of([&] { store->touch(99, 1, 2); }), Contains("holds no model 99"));
  CHECK_THAT(store_error_of([&] { store->data(99); }), Contains("holds no model 99"));
  CHECK_THAT(store_error_of([&] { store->move(99, "/a.off", 2); }), Contains("holds no model 99"));
  CHECK(store->find_by_path("/a.off"));
}

TEST_CASE("readers see what another connection has committed") {
  const TemporaryDirectory folder;
  const auto writer = open_store(folder / "a.db");
  const auto reader = open_store_read_only(folder / "a.db");
  CHECK(reader->shapes().empty());
  writer->put(make_record("/a.off"), make_data(1));
  CHECK(reader->vectors(signature_mdbd_100).size() == 1);
  const Database other(folder / "a.db", Access::read_write);
  const Transaction writing(other, Transaction::Kind::writing);
  other.execute("DELETE FROM shapes");
  CHECK(reader->vectors(signature_mdbd_100).size() == 1);
  CHECK(is_same(reader->data(1), make_data(1)));
}

TEST_CASE("a database that is removed or replaced while it is open is noticed") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = store->put(make_record("/a.off"), make_data(1));
  std::filesystem::rename(folder / "a.db", folder / "b.db");
  const bool is_replaced = GENERATE(false, true);
  if (is_replaced) std::filesystem::copy_file(folder / "b.db", folder / "a.db");
  const auto message = Contains("a.db: was moved, replaced or removed");
  CHECK_THROWS_WITH(store->put(make_record("/b.off"), make_data(2)), message);
  CHECK_THROWS_WITH(store->touch(id, 1, 1), message);
  CHECK_THROWS_WITH(store->move(id, "/c.off", 1), message);
  CHECK_THROWS_WITH(store->remove(id), message);
}

TEST_CASE("further signatures stand beside mdbd-100 until the model is put again") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = store->put(make_record("/a.off"), make_data(1));
  const std::int64_t other = store->put(make_record("/b.off"), make_data(2));
  store->put_vector(id, "esf", std::vector<float>{1, 2, 3});
  store->put_vector(id, "esf", std::vector<float>{4, 5});

  const VectorTable vectors = store->vectors("esf");
  REQUIRE(vectors.size() == 1);
  CHECK(vectors[0].shape_id == id);
  CHECK(numbers(vectors[0]) == std::vector<float>{4, 5});
  CHECK(is_same(store->data(id), make_data(1)));
  CHECK(store->vectors(signature_mdbd_100).size() == 2);

  store->put(make_record("/a.off"), make_data(1));
  CHECK(store->vectors("esf").empty());
  CHECK(is_same(store->data(other), make_data(2)));
}

TEST_CASE("a further signature needs its model, finite numbers and a name of its own") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::vector<float> values{1, 2};
  CHECK_THROWS_AS(store->put_vector(7, "esf", values), StoreError);
  const std::int64_t failed = store->put(make_failed_record("/a.off"), {});
  CHECK_THROWS_AS(store->put_vector(failed, "esf", values), StoreError);
  const std::int64_t id = store->put(make_record("/b.off"), make_data(1));
  CHECK_THROWS_AS(store->put_vector(id, signature_mdbd_100, values), StoreError);
  CHECK_THROWS_AS(store->put_vector(id, "esf", std::vector<float>{std::nanf("")}), StoreError);
  CHECK(store->vectors("esf").empty());
}
