#include "db/merge_stores.h"

#include <catch2/catch.hpp>

#include "tests/store/models.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

ShapeRecord record_at(const std::string& path, std::int64_t modified_ns) {
  ShapeRecord record = make_record(path);
  record.modified_ns = modified_ns;
  return record;
}

}  // namespace

TEST_CASE("models are added, and replaced by those of newer files and by ones that are indexed") {
  const TemporaryDirectory folder;
  const auto source = open_store(folder / "source.db");
  const auto target = open_store(folder / "target.db");
  source->put(record_at("/new.off", 1), make_data(1));
  source->put(record_at("/newer.off", 9), make_data(2));
  source->put(record_at("/older.off", 1), make_data(3));
  source->put(record_at("/mended.off", 1), make_data(4));
  source->put(make_failed_record("/broken.off"), {});
  target->put(record_at("/newer.off", 5), make_data(12));
  target->put(record_at("/older.off", 5), make_data(13));
  target->put(make_failed_record("/mended.off"), {});
  target->put(record_at("/broken.off", 1), make_data(15));

  const MergeSummary summary = merge_store(*source, *target);
  CHECK(summary.added == 1);
  CHECK(summary.replaced == 2);
  CHECK(summary.kept == 2);
  const auto data_of = [&](const std::string& path) {
    return target->data(target->find_by_path(path)->id);
  };
  CHECK(is_same(data_of("/new.off"), make_data(1)));
  CHECK(is_same(data_of("/newer.off"), make_data(2)));
  CHECK(is_same(data_of("/older.off"), make_data(13)));
  CHECK(is_same(data_of("/mended.off"), make_data(4)));
  CHECK(is_same(data_of("/broken.off"), make_data(15)));

  const MergeSummary again = merge_store(*source, *target);
  CHECK(again.added + again.replaced == 0);
  CHECK(target->shapes().size() == 5);
}

TEST_CASE("databases of different recipes are not merged") {
  const TemporaryDirectory folder;
  const auto source = open_store(folder / "source.db", Recipe{.balls = 300});
  const auto target = open_store(folder / "target.db");
  CHECK_THAT(store_error_of([&] { merge_store(*source, *target); }),
             Catch::Contains("balls 500 against 300"));
}
