#include "query/vector_cache.h"

#include <fstream>
#include <iterator>
#include <random>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "query/answer_query.h"
#include "query/exact_search.h"
#include "tests/query/vector_tables.h"
#include "tests/store/child_process.h"
#include "tests/store/models.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace fs = std::filesystem;

namespace {

constexpr std::size_t dimension = 12;

VectorTable make_table(std::size_t rows) {
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  std::vector<Model> models;
  for (std::size_t row = 0; row < rows; ++row) {
    Model model{static_cast<std::int64_t>(2 * row + 1), "/m/" + std::to_string(row * row), 0.5, {}};
    for (std::size_t i = 0; i < dimension; ++i) model.values.push_back(normal(random));
    models.push_back(std::move(model));
  }
  return table_of(models);
}

std::vector<MetricBlock> blocks_of(PointNorm norm) {
  return {{.first = 0, .count = 5, .norm = norm},
          {.first = 5, .count = dimension - 5, .weight = 0.5, .norm = norm}};
}

void check_same(const VectorTable& left, const VectorTable& right) {
  REQUIRE(left.size() == right.size());
  for (std::size_t row = 0; row < left.size(); ++row) {
    const StoredVector a = left[row];
    const StoredVector b = right[row];
    const bool is_same = a.shape_id == b.shape_id && a.path == b.path && a.scale == b.scale &&
                         std::ranges::equal(a.values, b.values);
    if (!is_same) FAIL_CHECK("row " << row);
  }
  CHECK(left.largest_number() == right.largest_number());
  CHECK(left.largest_magnitude() == right.largest_magnitude());
}

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t count_entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// A store of models 1 to `count` and a search in it that caches whatever its size.
struct Collection {
  explicit Collection(int count) : store(open_store(folder / "a.db")) {
    for (int i = 1; i <= count; ++i) add(i);
  }
  void add(int seed) {
    ShapeData data = make_data(seed);
    data.fused.resize(312, 0.5F);
    store->put(make_record("/" + std::to_string(seed)), data);
  }
  QueryAnswer answer(SignatureKind signature = SignatureKind::mdbd_100) const {
    QueryOptions options{.signature = signature};
    options.cached_database = folder / "a.db";
    options.least_cached_models = 0;
    return query_by_id(*store, 1, options);
  }
  fs::path cache() const { return vector_cache_path(folder / "a.db", SignatureKind::mdbd_100); }

  TemporaryDirectory folder;
  std::unique_ptr<ShapeStore> store;
};

std::vector<std::pair<std::string, double>> matches_of(const QueryAnswer& answer) {
  std::vector<std::pair<std::string, double>> matches;
  for (const Match& match : answer.result.matches) matches.emplace_back(match.path, match.distance);
  return matches;
}

}  // namespace

TEST_CASE("a cache gives back what was written, and sketches that bound the same") {
  const TemporaryDirectory folder;
  const PointNorm norm = GENERATE(PointNorm::l1, PointNorm::l2);
  const VectorTable table = make_table(GENERATE(1U, 7U, 64U, 1001U));
  const Sketches sketches = make_sketches(table, blocks_of(norm));
  REQUIRE(write_vector_cache(folder / "c", "key", table, sketches));
  CHECK(count_entries(folder.path()) == 1);
  const std::optional<CachedVectors> cached = read_vector_cache(folder / "c", "key");
  REQUIRE(cached);
  check_same(cached->table, table);
  CHECK(std::ranges::equal(cached->sketches.list.groups(), sketches.list.groups()));
  CHECK(cached->sketches.map.norm() == norm);
  CHECK(cached->sketches.map.margin(1.0) == sketches.map.margin(1.0));
  std::vector<float> before(sketches.map.size());
  std::vector<float> after(sketches.map.size());
  sketches.map.write(table.values(0), before);
  cached->sketches.map.write(table.values(0), after);
  CHECK(before == after);
}

TEST_CASE("a cache of something else, cut or too long is none") {
  const TemporaryDirectory folder;
  const VectorTable table = make_table(100);
  const Sketches sketches = make_sketches(table, blocks_of(PointNorm::l2));
  REQUIRE(write_vector_cache(folder / "c", "key", table, sketches));
  CHECK_FALSE(read_vector_cache(folder / "c", "another key"));
  CHECK_FALSE(read_vector_cache(folder / "nothing", "key"));
  CHECK_FALSE(read_vector_cache(folder.path(), "key"));
  const std::string content = read_file(folder / "c");
  for (std::size_t size = 0; size < content.size(); size += 1001) {
    folder.write("d", content.substr(0, size));
    CHECK_FALSE(read_vector_cache(folder / "d", "key"));
  }
  folder.write("d", content + '\0');
  CHECK_FALSE(read_vector_cache(folder / "d", "key"));
}

TEST_CASE("of a damaged cache nothing is ever read that was not written") {
  const TemporaryDirectory folder;
  const VectorTable table = make_table(100);
  const Sketches sketches = make_sketches(table, blocks_of(PointNorm::l2));
  REQUIRE(write_vector_cache(folder / "c", "key", table, sketches));
  const std::string content = read_file(folder / "c");
  std::mt19937 random(2);
  std::size_t noticed = 0;
  for (std::size_t i = 0; i < 600; ++i) {
    std::string damaged = content;
    const std::size_t place = i < 300 ? i : random() % content.size();
    damaged[place] = static_cast<char>(damaged[place] ^ (1 << random() % 8));
    folder.write("d", damaged);
    try {
      const std::optional<CachedVectors> cached = read_vector_cache(folder / "d", "key");
      if (cached) {
        check_same(cached->table, table);
        CHECK(std::ranges::equal(cached->sketches.list.groups(), sketches.list.groups()));
      } else {
        ++noticed;
      }
    } catch (const DamagedFile&) {
      ++noticed;
    }
  }
  CHECK(noticed > 300);
}

TEST_CASE("a cache that is removed or replaced while it is read stays what it was") {
  const TemporaryDirectory folder;
  const VectorTable table = make_table(1000);
  const Sketches sketches = make_sketches(table, blocks_of(PointNorm::l2));
  REQUIRE(write_vector_cache(folder / "c", "key", table, sketches));
  const std::optional<CachedVectors> cached = read_vector_cache(folder / "c", "key");
  const VectorTable other = make_table(3);
  REQUIRE(write_vector_cache(folder / "c", "key", other,
                             make_sketches(other, blocks_of(PointNorm::l2))));
  fs::remove(folder / "c");
  check_same(cached.value().table, table);
}

TEST_CASE("a cache is not written where another program writes it, but over what one left") {
  const TemporaryDirectory folder;
  const VectorTable table = make_table(10);
  const Sketches sketches = make_sketches(table, blocks_of(PointNorm::l2));
  folder.write("c.unfinished", std::string(100'000, 'x'));
  {
    const int other = open((folder / "c.unfinished").c_str(), O_RDWR);
    REQUIRE(flock(other, LOCK_EX) == 0);
    CHECK_FALSE(write_vector_cache(folder / "c", "key", table, sketches));
    CHECK(fs::file_size(folder / "c.unfinished") == 100'000);
    close(other);
  }
  CHECK(write_vector_cache(folder / "c", "key", table, sketches));
  CHECK(read_vector_cache(folder / "c", "key"));
  CHECK(count_entries(folder.path()) == 1);
}

TEST_CASE("a cache answers like the store, and is made anew when that has changed") {
  Collection c(20);
  const auto expected = matches_of(query_by_id(*c.store, 1));
  CHECK(matches_of(c.answer()) == expected);
  REQUIRE(fs::exists(c.cache()));
  const auto written = fs::last_write_time(c.cache());
  CHECK(matches_of(c.answer()) == expected);
  CHECK(fs::last_write_time(c.cache()) == written);
  c.add(100);
  CHECK(c.answer().result.compared == 21);
  c.store->remove(c.store->find_by_path("/2")->id);
  const auto left = matches_of(c.answer());
  CHECK(left == matches_of(query_by_id(*c.store, 1)));
  CHECK(left != expected);
  CHECK(matches_of(c.answer(SignatureKind::mdbd_fused)).size() == 10);
  CHECK(fs::exists(vector_cache_path(c.folder / "a.db", SignatureKind::mdbd_fused)));
}

TEST_CASE("filters and chirality search what is cached") {
  const Collection c(20);
  c.answer();
  QueryOptions options{.count = 5};
  options.filter.glob = "1?";
  options.has_chirality = GENERATE(false, true);
  const auto expected = matches_of(query_by_id(*c.store, 1, options));
  options.cached_database = c.folder / "a.db";
  CHECK(matches_of(query_by_id(*c.store, 1, options)) == expected);
  CHECK(expected.front().first == "/10");
}

TEST_CASE("a damaged cache costs nothing but time, whatever part of it is damaged") {
  const Collection c(40);
  const SignatureKind signature = GENERATE(SignatureKind::mdbd_100, SignatureKind::mdbd_fused);
  const fs::path cache = vector_cache_path(c.folder / "a.db", signature);
  const auto expected = matches_of(c.answer(signature));
  const std::string content = read_file(cache);
  std::size_t remade = 0;
  for (std::size_t block = 0; block < content.size(); block += CheckedFile::block_size) {
    std::string damaged = content;
    for (std::size_t i = 0; i < CheckedFile::block_size; ++i) damaged[block + i] ^= 1;
    c.folder.write(cache.filename().string(), damaged);
    INFO("byte " << block);
    CHECK(matches_of(c.answer(signature)) == expected);
    remade += read_file(cache) == content ? 1 : 0;
  }
  CHECK(remade > content.size() / CheckedFile::block_size / 2);
}

TEST_CASE("damage is made good from the database, whenever it turns up") {
  const Collection c(40);
  QueryOptions options;
  options.cached_database = c.folder / "a.db";
  options.least_cached_models = 0;
  options.is_approximate = GENERATE(false, true);
  if (GENERATE(false, true)) options.filter.glob = "[13]*";
  const auto expected = matches_of(query_by_id(*c.store, 1, options));
  const std::string content = read_file(c.cache());
  REQUIRE_FALSE(content.empty());
  for (std::size_t block = 0; block < content.size(); block += CheckedFile::block_size) {
    std::string damaged = content;
    damaged.replace(block, CheckedFile::block_size, CheckedFile::block_size, 'x');
    c.folder.write(c.cache().filename().string(), damaged);
    INFO("byte " << block);
    ShapeSearch search(*c.store, options);
    CHECK(matches_of(search.by_id(1)) == expected);
    CHECK(matches_of(search.by_id(1)) == expected);
  }
}

TEST_CASE("where no cache can be written, the store is searched") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "sub" / "a.db";
  fs::create_directory(path.parent_path());
  for (int i = 1; i < 9; ++i) {
    open_store(path)->put(make_record("/" + std::to_string(i)), make_data(i));
  }
  open_to_all(folder.path(), fs::perms::owner_all);
  open_to_all(path.parent_path(), fs::perms::owner_read | fs::perms::owner_exec);
  CHECK(run_unprivileged([&] {
          QueryOptions options{.count = 3};
          options.cached_database = path;
          options.least_cached_models = 0;
          const auto store = open_store_read_only(path);
          return std::to_string(query_by_id(*store, 1, options).result.matches.size());
        }) == "3");
  CHECK(count_entries(path.parent_path()) == 1);
  fs::permissions(path.parent_path(), fs::perms::owner_all);
}

TEST_CASE("where a damaged cache cannot be replaced, the store is searched") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "a.db";
  for (int i = 1; i < 9; ++i) {
    open_store(path)->put(make_record("/" + std::to_string(i)), make_data(i));
  }
  QueryOptions options{.count = 3};
  options.cached_database = path;
  options.least_cached_models = 0;
  const auto expected = matches_of(query_by_id(*open_store_read_only(path), 1, options));
  const fs::path cache = vector_cache_path(path, SignatureKind::mdbd_100);
  std::string content = read_file(cache);
  constexpr std::size_t table_blocks = 5;
  content.replace(content.size() - table_blocks * CheckedFile::block_size, std::string::npos,
                  table_blocks * CheckedFile::block_size, 'x');
  folder.write(cache.filename().string(), content);
  // Where a folder has this name, nothing can be written in place of the cache.
  fs::create_directory(fs::path(cache) += ".unfinished");
  CHECK(matches_of(query_by_id(*open_store_read_only(path), 1, options)) == expected);
  CHECK(read_file(cache) == content);
}

TEST_CASE("small collections are not cached") {
  const Collection c(20);
  QueryOptions options;
  options.cached_database = c.folder / "a.db";
  query_by_id(*c.store, 1, options);
  CHECK_FALSE(fs::exists(c.cache()));
}
