#include "features/implicit/read_csg.h"

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "tests/implicit/solids.h"

namespace mdbd::test {
namespace {

std::string reason_against(const std::string& document) {
  try {
    read_csg(document);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

std::string reason_against_solid(const std::string& solid) {
  return reason_against(csg_document(solid));
}

std::string nested(int depth) {
  std::string document = R"({"sphere": {"radius": 1}})";
  for (int i = 0; i < depth; ++i) document = R"({"union": [)" + document + "]}";
  return document;
}

}  // namespace

TEST_CASE("Mistakes in a solid are named with their place") {
  CHECK(reason_against_solid(R"({"sphere": {"radius": 0}})") ==
        "/solid/sphere/radius: must be above 0");
  CHECK(reason_against_solid(
            R"({"union": [{"sphere": {"radius": 1}}, {"sphere": {"radius": -1}}]})") ==
        "/solid/union/1/sphere/radius: must be above 0");
  CHECK(reason_against_solid(R"({"sphere": {"radius": "1"}})") ==
        "/solid/sphere/radius: must be a number");
  CHECK(reason_against_solid(R"({"sphere": {}})") == "/solid/sphere: has no \"radius\"");
  CHECK(reason_against_solid(R"({"sphere": 1})") == "/solid/sphere: must be an object");
  CHECK(reason_against_solid(R"({"sphere": {"radius": 1, "centre": [0, 0, 0]}})") ==
        "/solid/sphere: \"centre\" is not known here");
  CHECK(reason_against_solid(R"({"sphere": {"radius": 1, "center": [0, 0]}})") ==
        "/solid/sphere/center: must be an array of three numbers");
  CHECK(reason_against_solid(R"({"sphere": {"radius": 1, "center": [0, 0, null]}})") ==
        "/solid/sphere/center/2: must be a number");
  CHECK(reason_against_solid(R"({"sphere": {"radius": 1e300}})") ==
        "/solid/sphere/radius: must be between -1e15 and 1e15");
  CHECK(reason_against_solid(R"({"box": {"min": [0, 0, 0], "max": [1, 0, 1]}})") ==
        "/solid/box: \"max\" must be above \"min\" in all three");
  CHECK(
      reason_against_solid(R"({"cylinder": {"from": [1, 1, 1], "to": [1, 1, 1], "radius": 1}})") ==
      "/solid/cylinder: \"from\" and \"to\" must be different");
  CHECK(reason_against_solid(R"({"torus": {"radius": 1, "tube_radius": 1}})") ==
        "/solid/torus/tube_radius: must be below the radius of the torus");
  CHECK(reason_against_solid(R"({"halfspace": {"point": [0, 0, 0], "outward": [0, 0, 0]}})") ==
        "/solid/halfspace/outward: must not be zero");
  CHECK(reason_against_solid(R"({"union": []})") ==
        "/solid/union: must be an array of at least one solid");
  CHECK(reason_against_solid(R"({"union": {"sphere": {"radius": 1}}})") ==
        "/solid/union: must be an array of at least one solid");
  CHECK(reason_against_solid("[]") == "/solid: must be an object that names a solid");
  CHECK(reason_against_solid("{}") == "/solid: must be an object that names a solid");
  CHECK_THAT(reason_against_solid(R"({"ball": {"radius": 1}})"),
             Catch::StartsWith("/solid/ball: is none of sphere, box,"));
  CHECK(reason_against_solid(R"({"sphere": {"radius": 1}, "box": {}})") ==
        "/solid: names two solids, \"box\" and \"sphere\"");
  CHECK(reason_against_solid(R"({"scale": 2})") == "/solid: has no \"of\"");
  CHECK(reason_against_solid(R"({"scale": 0, "of": {"sphere": {"radius": 1}}})") ==
        "/solid/scale: must be above 0");
  CHECK(reason_against_solid(R"({"rotate": {"axis": [0, 0, 1]}, "of": {}})") ==
        "/solid/rotate: has no \"degrees\"");
}

TEST_CASE("A document that is no solid says so") {
  CHECK_THAT(reason_against("{"), Catch::StartsWith("no JSON document: "));
  CHECK_THAT(reason_against("\xff\xfe"), Catch::StartsWith("no JSON document: "));
  CHECK_THAT(reason_against(""), Catch::StartsWith("no JSON document: "));
  for (const char* other : {"{}", "[]", "1", R"({"format": "other"})", R"({"format": 1})"}) {
    CHECK_THAT(reason_against(other), Catch::Contains("the JSON document is no solid"));
  }
  CHECK(reason_against(R"({"format": "mdbd-csg"})") == "/: has no \"solid\"");
  CHECK(reason_against(R"({"format": "mdbd-csg", "color": 1, "solid": {}})") ==
        "/: \"color\" is not known here");
}

TEST_CASE("Depth and number are limited") {
  CHECK(reason_against_solid(nested(64)).empty());
  CHECK_THAT(reason_against_solid(nested(65)), Catch::Contains("is nested deeper than 64"));
  CHECK_FALSE(reason_against_solid(nested(2000)).empty());
  CHECK_FALSE(reason_against(std::string(1'000'000, '[')).empty());
  std::string many;
  for (int i = 0; i < 2001; ++i) {
    many += (i == 0 ? "" : ",") + std::string(R"({"sphere": {"radius": 1}})");
  }
  CHECK_THAT(reason_against_solid(R"({"union": [)" + many + "]}"),
             Catch::Contains("/solid/union/2000: is one primitive more than 2000"));
}

TEST_CASE("Placements come from the outside in") {
  const CsgSolid solid = csg_solid(
      R"({"translate": [1, 0, 0], "of": {"rotate": {"axis": [0, 0, 2], "degrees": 90}, "of":
          {"scale": 2, "of": {"sphere": {"center": [1, 0, 0], "radius": 1}}}}})");
  REQUIRE(solid.size() == 1);
  CHECK(solid.surfaces()[0].point.isApprox(Eigen::Vector3d(1, 2, 0)));
  CHECK(solid.surfaces()[0].radius == 2.0);
}

}  // namespace mdbd::test
