#include "indexer/index_report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace mdbd;
using Catch::Contains;

namespace {

IndexSummary sample_summary() {
  IndexSummary summary;
  summary.indexed = 12;
  summary.unchanged = 178;
  summary.gone = 3;
  summary.seconds = 3.25;
  summary.failures = {{"/a/\xff\n\"b\".off", "empty \xfe file", false}};
  return summary;
}

}  // namespace

TEST_CASE("the JSON summary has every count, whatever the file names") {
  const auto object = nlohmann::json::parse(format_index_json(sample_summary(), "mdbd.db", false));
  CHECK(object["indexed"] == 12);
  CHECK(object["unchanged"] == 178);
  CHECK(object["moved"] == 0);
  CHECK(object["failed"] == 1);
  CHECK(object["removed"] == 0);
  CHECK(object["seconds"] == 3.25);
  CHECK(object["database"] == "mdbd.db");
  CHECK(object["interrupted"] == false);
  CHECK(object["failures"][0]["path"] == "/a/\uFFFD\n\"b\".off");
  CHECK(object["failures"][0]["reason"] == "empty \uFFFD file");
}

TEST_CASE("a summary without failures has an empty list of them") {
  const auto object = nlohmann::json::parse(format_index_json({}, "mdbd.db", true));
  CHECK(object["failures"].is_array());
  CHECK(object["failures"].empty());
  CHECK(object["dry_run"] == true);
}

TEST_CASE("the summary for people") {
  const std::string text = format_index_text(sample_summary(), "mdbd.db", false);
  CHECK_THAT(text, Contains("indexed         12\nunchanged      178\nfailed           1\n"));
  CHECK_THAT(text, Contains("--prune") && Contains("mdbd.db, 3.2 s") && !Contains("moved"));
  const std::string dry = format_index_text(sample_summary(), "mdbd.db", true);
  CHECK_THAT(dry, Contains("to index") && Contains("Nothing was written"));
}

TEST_CASE("the list of old failures is short") {
  IndexSummary summary = sample_summary();
  CHECK(format_old_failures(summary).empty());
  for (int i = 0; i < 22; ++i) summary.failures.push_back({"/old.off", "bad", true});
  CHECK_THAT(format_old_failures(summary), Contains("/old.off: bad") && Contains("and 12 more"));
}
