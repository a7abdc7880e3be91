#include "query/query_output.h"

#include <algorithm>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using Catch::Matchers::Contains;
using mdbd::format_csv;
using mdbd::format_explained_table;
using mdbd::format_json;
using mdbd::format_table;
using mdbd::SearchResult;

namespace {

SearchResult example() {
  SearchResult result;
  result.compared = 3;
  result.matches = {{0, 7, "/models/chair/a.off", 2.5, 0.1 + 0.2, {0.1, 0.2}, {}, {}},
                    {1, 9, "/other/table, \"big\".obj", 1.0, 1.0, {1.0, 0.0}, {}, {}}};
  result.part_names = {"radii", "walk"};
  return result;
}

/// The example as the answer to a query by something else, with lists of two radii and one sum.
mdbd::QueryAnswer explained_example() {
  mdbd::QueryAnswer answer{.query = "q.off", .result = example()};
  answer.radius_count = 2;
  answer.query_scale = 4.0;
  answer.query_data = {.balls = {{{1, 2, 3}, 2.0}}, .signature = {0.5F, 0.0F, 1.0F}, .fused = {}};
  answer.match_data = {{.balls = {{{4, 5, 6}, 1.25}, {{7, 8, 9}, 0.625}},
                        .signature = {0.5F, 0.25F, 0.5F},
                        .fused = {}},
                       answer.query_data};
  return answer;
}

}  // namespace

TEST_CASE("the table shows paths below the folder relative to it") {
  const std::string table = format_table(example(), "/models");
  CHECK_THAT(table, Contains("   1   0.300000  chair/a.off\n"));
  CHECK_THAT(table, Contains("   2   1.000000  /other/table, \"big\".obj\n"));
  CHECK_THAT(format_table(example(), "/mod"), Contains("  /models/chair/a.off\n"));
  CHECK(format_table({}, "/").empty());
}

TEST_CASE("an explained table shows what each part makes of the distance") {
  const std::string table = format_explained_table(explained_example(), "/models");
  CHECK_THAT(table, Contains("rank   distance       radii%        walk%  model\n"));
  CHECK_THAT(table, Contains("   1   0.300000           33           67  chair/a.off\n"));
}

TEST_CASE("an explained match has both lists as pictures, and the balls that differ") {
  const std::string table = format_explained_table(explained_example(), "/models");
  CHECK_THAT(table, Contains("radii      query  \u2588 \n") &&
                        Contains("           match  \u2588\u2584\n") &&
                        Contains("walk sums  query  \u2588\n") &&
                        Contains("           match  \u2584\n") &&
                        Contains("ball 2: 0.2500 R at (7, 8, 9), in the query none\n"));
  CHECK_THAT(table, !Contains("ball 1:"));
  CHECK_THAT(table, Catch::EndsWith("big\".obj\n"));  // nothing differs there
  const auto document = nlohmann::json::parse(format_json(explained_example(), true));
  CHECK(document["radii"] == nlohmann::json{0.5, 0.0});
  CHECK(document["walk_sums"] == nlohmann::json{1.0});
  CHECK(document["matches"][0]["radii"] == nlohmann::json{0.5, 0.25});
  CHECK(document["matches"][0]["balls"] ==
        nlohmann::json{{{"ball", 2},
                        {"query", {{"radius", 0.0}}},
                        {"match", {{"radius", 0.25}, {"center", {7.0, 8.0, 9.0}}}}}});
  CHECK(document["matches"][1]["balls"].empty());
}

TEST_CASE("hands and the numbers that differ the most are shown in each form of output") {
  SearchResult result = example();
  result.matches[0].hand = mdbd::Hand::same;
  result.matches[1].hand = mdbd::Hand::mirrored;
  result.matches[1].differences = {{"radius 3", 0.5F, 0.75F}};
  mdbd::QueryAnswer answer = explained_example();
  answer.result = result;
  const std::string table = format_explained_table(answer, "/models");
  CHECK_THAT(table, Contains("%  hand      model\n") && Contains("  same      chair/a.off\n") &&
                        Contains("  mirrored  /other/table, \"big\".obj\n") &&
                        Contains("radius 3: 0.7500, in the query 0.5000 (+0.2500)\n"));
  CHECK_THAT(format_table(result, "/models"), !Contains("radius 3"));
  const auto document = nlohmann::json::parse(format_json({"q", result}));
  CHECK(document["matches"][0]["hand"] == "same");
  CHECK_FALSE(document["matches"][0].contains("differences"));
  CHECK(document["matches"][1]["differences"] ==
        nlohmann::json{{{"number", "radius 3"}, {"query", 0.5}, {"match", 0.75}}});
  CHECK_THAT(format_csv(result),
             Contains(",scale,hand\n") && Contains(",2.5,same\n") && Contains(",1,mirrored\n"));
}

TEST_CASE("the table has one line a match, whatever a file is called") {
  SearchResult result = example();
  result.matches[0].path = "/models/two\nlines\x1b[2J";
  const std::string table = format_table(result, "/");
  CHECK(std::count(table.begin(), table.end(), '\n') == 3);
  CHECK(table.find('\x1b') == std::string::npos);
}

TEST_CASE("JSON holds every field and reads back to the same numbers") {
  const auto document = nlohmann::json::parse(format_json({"chair.ply", example()}));
  CHECK(document["query"] == "chair.ply");
  CHECK(document["exact"] == true);
  REQUIRE(document["matches"].size() == 2);
  CHECK(document["matches"][0] == nlohmann::json{{"rank", 1},
                                                 {"id", 7},
                                                 {"path", "/models/chair/a.off"},
                                                 {"distance", 0.1 + 0.2},
                                                 {"radii_distance", 0.1},
                                                 {"walk_distance", 0.2},
                                                 {"scale", 2.5}});
  CHECK(document["matches"][1]["rank"] == 2);
}

TEST_CASE("JSON of an empty answer has an empty list") {
  CHECK(nlohmann::json::parse(format_json({"q", {}}))["matches"] == nlohmann::json::array());
}

TEST_CASE("names that are no UTF-8 become JSON all the same") {
  SearchResult result = example();
  result.matches[0].path = "/models/caf\xe9.off";
  const auto document = nlohmann::json::parse(format_json({"caf\xe9.off", result}));
  CHECK(document["query"] == "caf\xef\xbf\xbd.off");
  CHECK(document["matches"][0]["path"] == "/models/caf\xef\xbf\xbd.off");
}

TEST_CASE("CSV quotes what needs it") {
  CHECK(format_csv(example()) ==
        "rank,id,path,distance,radii_distance,walk_distance,scale\n"
        "1,7,/models/chair/a.off,0.30000000000000004,0.1,0.2,2.5\n"
        "2,9,\"/other/table, \"\"big\"\".obj\",1,1,0,1\n");
}

TEST_CASE("the answers of a batch name their queries") {
  const std::vector<mdbd::QueryAnswer> answers = {{"a,b.off", example()}, {"c.off", {}}};
  const auto document = nlohmann::json::parse(format_json(answers));
  REQUIRE(document.size() == 2);
  CHECK(document[0]["query"] == "a,b.off");
  CHECK(document[0]["matches"].size() == 2);
  CHECK(document[1]["matches"].empty());
  CHECK_THAT(format_csv(answers),
             Catch::StartsWith("query,rank,id,path,distance,radii_distance,walk_distance,scale\n"
                               "\"a,b.off\",1,7,/models/chair/a.off,"));
  CHECK(format_csv(std::vector<mdbd::QueryAnswer>{}).empty());
}
