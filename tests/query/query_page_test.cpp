#include "query/query_page.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "picture/encode_png.h"
#include "picture/thumbnail.h"
#include "query/ball_viewer.h"

using namespace mdbd;
using Catch::Matchers::Contains;

namespace {

QueryAnswer example() {
  QueryAnswer answer{.query = "/q/chair.ply", .result = {}};
  answer.radius_count = 2;
  answer.query_scale = 2.0;
  answer.query_data = {.balls = {{{1, 2, 3}, 1.0}}, .signature = {0.5F, 0.0F, 0.0F}, .fused = {}};
  answer.result.compared = 7;
  answer.result.part_names = {"radii", "walk"};
  Match match;
  match.id = 12;
  match.path = "/m/</script><b>'\"&.off";
  match.scale = 4.0;
  match.distance = 0.25;
  match.parts = {0.25, 0.0};
  answer.result.matches = {match};
  answer.match_data = {{.balls = {{{0, 0, 0}, 2.0}, {{0, 0, 3}, 1.0}},
                        .signature = {0.5F, 0.25F, 0.0F},
                        .fused = {},
                        .thumbnail = "PNG"}};
  return answer;
}

}  // namespace

TEST_CASE("a page names query and matches, and no name becomes markup") {
  const std::vector<QueryAnswer> answers = {example()};
  const std::string page = format_query_page(answers, {.signature = "mdbd-100"});
  CHECK_THAT(page, Contains("<h1>Models like chair.ply</h1>") && Contains("with 7 models") &&
                       Contains("0.250000") &&
                       Contains("&lt;/script&gt;&lt;b&gt;&#39;&quot;&amp;.off"));
  CHECK_THAT(page, !Contains("<b>") && !Contains("What makes the difference"));
}

TEST_CASE("a page shows thumbnails, and balls where there is none") {
  const std::vector<QueryAnswer> answers = {example()};
  const std::string page = format_query_page(answers, {.signature = "mdbd-100"});
  const auto source = [](const std::string& png) {
    return "src=\"data:image/png;base64," + encode_base64(png) + "\"";
  };
  CHECK_THAT(page,
             Contains(source("PNG")) && Contains(source(draw_balls(example().query_data.balls))));
}

TEST_CASE("an explained page marks the balls that differ, and has the lists") {
  const std::vector<QueryAnswer> answers = {example()};
  const std::string page =
      format_query_page(answers, {.signature = "mdbd-100", .is_explained = true});
  CHECK_THAT(page, Contains("data-query=\"q1\" data-match=\"m12\" data-differ=\"2\"") &&
                       Contains("radii 100") && Contains("aria-label=\"Radii by R\""));
}

TEST_CASE("the balls of a model are on the page once") {
  const std::vector<QueryAnswer> answers = {example(), example()};
  const std::string page = format_query_page(answers, {.signature = "mdbd-100"});
  const std::size_t first = page.find("\"m12\":[");
  REQUIRE(first != std::string::npos);
  CHECK(page.find("\"m12\":[", first + 1) == std::string::npos);
  CHECK_THAT(page, Contains("\"q1\":[0,0,0,500]") && Contains("\"q2\":["));
}

TEST_CASE("balls are whole thousandths of R about their middle") {
  CHECK(balls_to_json({{{10, 0, 0}, 1.0}, {{12, 4, 0}, 0.5}}, 2.0) ==
        "[-500,-1000,0,500,500,1000,0,250]");
  CHECK(balls_to_json({}, 1.0) == "[]");
}
