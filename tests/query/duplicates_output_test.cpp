#include "query/duplicates_output.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace mdbd;

namespace {

ShapeRecord make_record(std::int64_t id, const std::string& path) {
  ShapeRecord record;
  record.id = id;
  record.path = path;
  record.format = "off";
  record.scale = 2.0;
  return record;
}

/// A model with three copies: of the same bytes, enlarged, and decimated.
DuplicateReport make_report() {
  DuplicateGroup group{.models = {make_record(4, "/parts/a.off"), make_record(1, "/parts/b.off"),
                                  make_record(2, "/parts/c.off"), make_record(3, "/parts/d.off")}};
  group.pairs = {{.first = 0, .second = 1, .hand = Hand::same, .has_same_bytes = true},
                 {.first = 0,
                  .second = 2,
                  .distance = 0.02,
                  .deviation = 4e-8,
                  .scale_ratio = 25.4,
                  .hand = Hand::mirrored},
                 {.first = 0,
                  .second = 3,
                  .distance = 0.3,
                  .radii_distance = 0.05,
                  .deviation = 0.0025,
                  .hand = Hand::none},
                 {.first = 1, .second = 2, .distance = 0.02}};
  return {.groups = {group}, .compared = 9, .measured = 2, .not_measured = 1};
}

}  // namespace

TEST_CASE("the table of duplicates tells the evidence for each copy of the model to keep") {
  CHECK(format_duplicates_table(make_report(), "/") ==
        "keep  parts/a.off\n"
        "      parts/b.off\n        same bytes, distance 0.0000, same size, same hand\n"
        "      parts/c.off\n        other bytes, distance 0.0200, x 25.4, mirrored, same surface\n"
        "      parts/d.off\n        other bytes, distance 0.3000, same size, no hand, surfaces "
        "within "
        "0.25 % of R\n");
}

TEST_CASE("programs read the same evidence, and no deviation where none was measured") {
  const auto document = nlohmann::json::parse(format_duplicates_json(make_report(), 0.06));
  CHECK(document["surfaces_compared"] == 2);
  CHECK(document["surfaces_not_compared"] == 1);
  const auto& pairs = document["groups"][0]["pairs"];
  CHECK(document["groups"][0]["keep"] == 4);
  REQUIRE(pairs.size() == 4);
  CHECK(pairs[0]["deviation"].is_null());
  CHECK(pairs[2]["deviation"] == 0.0025);
  CHECK(pairs[2]["second"] == 3);

  const std::string csv = format_duplicates_csv(make_report());
  CHECK_THAT(csv,
             Catch::Matchers::Contains("\n1,4,4,/parts/a.off,1,/parts/b.off,0,0,,1,same,yes\n"));
  CHECK_THAT(csv, Catch::Matchers::Contains(
                      "\n1,4,4,/parts/a.off,3,/parts/d.off,0.3,0.05,0.0025,1,none,no\n"));
}
