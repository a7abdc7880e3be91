#include "features/shape_io/output_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "tests/support/temporary_directory.h"

using Catch::Matchers::Contains;
using mdbd::test::TemporaryDirectory;

namespace {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t entries_of(const TemporaryDirectory& directory) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(directory.path()), {}));
}

}  // namespace

TEST_CASE("a file is replaced as a whole, and nothing is left beside it") {
  const TemporaryDirectory directory;
  const auto path = directory.write("balls.csv", "old and longer");
  mdbd::write_file(path, "new");
  CHECK(read_file(path) == "new");
  CHECK(entries_of(directory) == 1);
}

TEST_CASE("a symbolic link is followed") {
  const TemporaryDirectory directory;
  const auto path = directory.write("balls.csv", "old");
  std::filesystem::create_symlink(path, directory / "link.csv");
  mdbd::write_file(directory / "link.csv", "new");
  CHECK(read_file(path) == "new");
  CHECK(std::filesystem::is_symlink(directory / "link.csv"));
}

TEST_CASE("a place that cannot be written is named") {
  const TemporaryDirectory directory;
  CHECK_THROWS_WITH(mdbd::write_file(directory / "none/balls.csv", ""),
                    Contains("none/balls.csv") && Contains("No such file"));
  std::filesystem::create_directory(directory / "balls.csv");
  CHECK_THROWS_AS(mdbd::write_file(directory / "balls.csv", ""), mdbd::IoError);
  CHECK(entries_of(directory) == 1);
}
