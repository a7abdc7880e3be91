#include "features/shape_io/content_hash.h"

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "tests/support/temporary_directory.h"

namespace mdbd::test {

TEST_CASE("The hash is XXH3 with 128 bits, in hexadecimal") {
  const TemporaryDirectory directory;
  // The published value for no input.
  CHECK(content_hash(directory.write("empty", "")) == "99aa06d3014798d86001c324468d497f");
}

TEST_CASE("The hash depends on every byte and on nothing else") {
  const TemporaryDirectory directory;
  std::string content(3'000'000, 'x');
  const std::string hash = content_hash(directory.write("one", content));
  CHECK(hash.size() == 32);
  CHECK(content_hash(directory.write("other.name", content)) == hash);
  content.back() = 'y';
  CHECK(content_hash(directory.write("one", content)) != hash);
  content.pop_back();
  CHECK(content_hash(directory.write("one", content)) != hash);
}

TEST_CASE("A file that cannot be hashed says why") {
  const TemporaryDirectory directory;
  CHECK_THROWS_AS(content_hash(directory / "missing"), IoError);
  CHECK_THROWS_WITH(content_hash(directory.path()), Catch::Contains("is a directory"));
}

}  // namespace mdbd::test
