#include "evaluation/write_outputs.h"

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "tests/support/temporary_directory.h"

namespace fs = std::filesystem;
using namespace mdbd;

TEST_CASE("reports are written where they were asked for") {
  const test::TemporaryDirectory directory;
  const ReportOutputs outputs{directory / "a.json", directory / "a.html"};
  require_writable(outputs);
  CHECK(fs::is_empty(directory.path()));
  write_outputs({}, outputs);
  CHECK(fs::file_size(outputs.json) > 0);
  CHECK(fs::file_size(outputs.html) > 0);
  require_writable(outputs);  // they may be replaced
}

TEST_CASE("nothing is written that was not asked for") {
  const ReportOutputs printed{"-", {}};
  CHECK(printed.is_json_printed());
  require_writable(printed);
  write_outputs({}, printed);
  CHECK_FALSE(fs::exists("-"));
}

TEST_CASE("what cannot be written is known beforehand") {
  const test::TemporaryDirectory directory;
  directory.write("file", "");
  CHECK_THROWS_AS(require_writable({directory / "none/a.json", {}}), IoError);
  CHECK_THROWS_AS(require_writable({{}, directory / "file/a.html"}), IoError);
  CHECK_THROWS_AS(require_writable({directory.path(), {}}), IoError);
  CHECK_THROWS_AS(require_writable({"/dev/full", {}}), IoError);
}
