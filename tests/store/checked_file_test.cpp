#include "store/checked_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

constexpr FileMagic magic = {'T', 'E', 'S', 'T', 'F', 'I', 'L', 'E'};
constexpr std::size_t block = CheckedFile::block_size;

std::vector<std::byte> make_section(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::byte> section(size);
  for (std::byte& byte : section) byte = static_cast<std::byte>(random());
  return section;
}

/// A file of three sections, of which the second is empty.
struct Written {
  Written() {
    REQUIRE(write_checked_file(folder / "f", magic,
                               std::vector<std::span<const std::byte>>{first, {}, second}));
    std::ifstream file(folder / "f", std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }

  std::shared_ptr<const CheckedFile> open(const std::string& content) const {
    folder.write("d", content);
    return CheckedFile::open(folder / "d", magic);
  }

  TemporaryDirectory folder;
  std::vector<std::byte> first = make_section(3 * block + 17, 1);
  std::vector<std::byte> second = make_section(2 * block, 2);
  std::string bytes;
  std::size_t content_size = 6 * block;
};

}  // namespace

TEST_CASE("a checked file holds its sections, each at the beginning of a block") {
  const Written written;
  const auto file = CheckedFile::open(written.folder / "f", magic);
  REQUIRE(file);
  CHECK(written.bytes.size() == checked_file_size(std::vector<std::span<const std::byte>>{
                                    written.first, {}, written.second}));
  REQUIRE(file->content().size() == written.content_size);
  const auto first = file->content().first(written.first.size());
  const auto second = file->content().subspan(4 * block);
  file->prefetch(second);
  CHECK_NOTHROW(file->check(first));
  CHECK_NOTHROW(file->check(second));
  CHECK_NOTHROW(file->check({}));
  CHECK(std::ranges::equal(first, written.first));
  CHECK(std::ranges::equal(second, written.second));
}

TEST_CASE("what is not there, of another kind or not of its full length is no checked file") {
  const Written written;
  CHECK_FALSE(CheckedFile::open(written.folder / "nothing", magic));
  CHECK_FALSE(CheckedFile::open(written.folder.path(), magic));
  CHECK_FALSE(CheckedFile::open(written.folder / "f", {'O', 'T', 'H', 'E', 'R'}));
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{39}, std::size_t{40},
                                 block, written.bytes.size() - block, written.bytes.size() - 1}) {
    CHECK_FALSE(written.open(written.bytes.substr(0, size)));
  }
  CHECK_FALSE(written.open(written.bytes + '\0'));
  CHECK_FALSE(written.open(written.bytes + std::string(block, '\0')));
}

TEST_CASE("a damaged front or table is noticed at once") {
  const Written written;
  const std::size_t end = 40 + written.content_size / block * 8;
  for (std::size_t place = 0; place < end; ++place) {
    std::string damaged = written.bytes;
    damaged[place] = static_cast<char>(damaged[place] ^ (1 << place % 8));
    if (written.open(damaged)) FAIL_CHECK("byte " << place);
  }
}

TEST_CASE("a damaged block is noticed when it is read, and only then") {
  const Written written;
  const std::size_t front = written.bytes.size() - written.content_size;
  std::mt19937 random(3);
  for (std::size_t damaged_block = 0; damaged_block < written.content_size / block;
       ++damaged_block) {
    std::string damaged = written.bytes;
    char& byte = damaged[front + damaged_block * block + random() % block];
    byte = static_cast<char>(byte ^ (1 << random() % 8));
    const auto file = written.open(damaged);
    REQUIRE(file);
    for (std::size_t i = 0; i < written.content_size / block; ++i) {
      const auto part = file->content().subspan(i * block + 5, 20);
      for (int time = 0; time < 2; ++time) {
        if (i == damaged_block) {
          CHECK_THROWS_AS(file->check(part), DamagedFile);
        } else {
          CHECK_NOTHROW(file->check(part));
        }
      }
    }
    CHECK_THROWS_AS(file->check(file->content()), DamagedFile);
    if (damaged_block > 0) {
      const auto across = file->content().subspan(damaged_block * block - 1, 2);
      CHECK_THROWS_AS(file->check(across), DamagedFile);
    }
  }
}

TEST_CASE("blocks are checked by any number of threads") {
  const Written written;
  const auto file = CheckedFile::open(written.folder / "f", magic);
  REQUIRE(file);
  std::vector<std::thread> threads;
  std::atomic<int> equal = 0;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (std::size_t first = 0; first < written.first.size(); ++first) {
        const auto byte = file->content().subspan(first, 1);
        file->check(byte);
        if (byte[0] == written.first[first]) ++equal;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(equal == static_cast<int>(4 * written.first.size()));
}
