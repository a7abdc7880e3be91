#include "decompose/ball_output.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "features/core/errors.h"

using Catch::Matchers::Contains;
using mdbd::BallFormat;
using mdbd::DecomposedModel;

namespace {

DecomposedModel example() {
  DecomposedModel model;
  model.path = "part.stl";
  model.representation = "mesh";
  model.statistics = R"({"faces":12})";
  model.decomposition.balls = {{{0.1, -2.0, 1e-20}, 1.0 / 3.0}, {{1.0, 0.0, 0.0}, 0.25}};
  model.decomposition.upper_bounds = {0.334, 0.25};
  model.decomposition.scale = 1.5;
  model.decomposition.cost = {.distance_queries = 7, .cells = 8};
  model.contacts.neighbours = {{1}, {0}};
  model.certificate = {
      .containment_violation = 1e-12, .overlap_violation = 0.0, .maximality_gap = 2e-3};
  return model;
}

}  // namespace

TEST_CASE("the ending gives the format, in upper or lower case") {
  CHECK(mdbd::ball_format_of("a/b.csv") == BallFormat::csv);
  CHECK(mdbd::ball_format_of("b.XYZR") == BallFormat::xyzr);
  CHECK(mdbd::ball_format_of("b.csv.json") == BallFormat::json);
  CHECK(mdbd::ball_format_of("b.svg") == BallFormat::svg);
  CHECK_FALSE(mdbd::ball_format_of("b.txt"));
  CHECK_FALSE(mdbd::ball_format_of("csv"));
}

TEST_CASE("balls are written in the shortest form that reads back") {
  CHECK(format_csv(example().decomposition) ==
        "x,y,z,r\n0.1,-2,1e-20,0.3333333333333333\n1,0,0,0.25\n");
  CHECK(format_xyzr(example().decomposition) == "0.1 -2 1e-20 0.3333333333333333\n1 0 0 0.25\n");
}

TEST_CASE("JSON holds balls, evidence and recipe") {
  const auto document = nlohmann::json::parse(format_balls(example(), BallFormat::json));
  CHECK(document["model"] == "part.stl");
  CHECK(document["statistics"]["faces"] == 12);
  CHECK(document["scale"] == 1.5);
  CHECK(document["termination"] == to_string(mdbd::Termination::ball_count));
  CHECK(document["balls"] == nlohmann::json{{0.1, -2.0, 1e-20, 1.0 / 3.0}, {1.0, 0.0, 0.0, 0.25}});
  CHECK(document["upper_bounds"] == nlohmann::json{0.334, 0.25});
  CHECK(document["contacts"] == nlohmann::json::array({{0, 1}}));
  CHECK(document["certificate"]["containment_violation"] == 1e-12);
  CHECK(document["certificate"]["overlap_violation"] == 0.0);
  CHECK(document["certificate"]["maximality_gap"] == 2e-3);
  CHECK(document["cost"] == nlohmann::json{{"distance_queries", 7}, {"cells", 8}});
  CHECK(document["recipe"]["radius_tolerance"] == 1e-3);
  CHECK(document["recipe"]["scaling"] == "enclosing-ball");
}

TEST_CASE("a picture holds the outlines and the discs of a domain in the plane") {
  DecomposedModel model = example();
  model.outlines = {{{0, 0}, {4, 0}, {4, 2}}};
  const std::string text = format_balls(model, BallFormat::svg);
  CHECK_THAT(text,
             Contains("viewBox=\"-0.08 -0.08 4.16 2.16\"") && Contains("d=\"M0 0L4 0L4 2Z\""));
  CHECK_THAT(text, Contains("<circle cx=\"1\" cy=\"0\" r=\"0.25\""));
}

TEST_CASE("a solid is not drawn") {
  CHECK_THROWS_AS(format_balls(example(), BallFormat::svg), mdbd::InvalidInput);
}

TEST_CASE("a shortage is explained, and only a shortage") {
  DecomposedModel model = example();
  CHECK(explain_shortage(model).empty());
  model.decomposition.termination = mdbd::Termination::minimum_radius;
  CHECK_THAT(explain_shortage(model), Contains("2 of 500 balls") && Contains("minimum radius"));
}
