#include "features/shape_io/read_planar_domain.h"

#include <numbers>
#include <random>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/planar_shape.h"
#include "features/shape_io/flatten_curves.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

std::string svg(const std::string& content) {
  return R"(<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg">)" + content + "</svg>";
}

double svg_area(const std::string& content) { return area(simplify(read_svg(svg(content)))); }

}  // namespace

TEST_CASE("the shapes of SVG have their areas") {
  const double pi = std::numbers::pi;
  const double rounding = 10 * flattening_tolerance;
  CHECK(svg_area(R"(<rect x="1" y="2" width="4" height="3"/>)") == Approx(12.0));
  CHECK(svg_area(R"(<rect width="4" height="3" rx="1"/>)") ==
        Approx(12 - 4 + pi).epsilon(rounding));
  CHECK(svg_area(R"(<circle cx="5" r="2"/>)") == Approx(4 * pi).epsilon(rounding));
  CHECK(svg_area(R"(<ellipse cx="5" rx="2" ry="3"/>)") == Approx(6 * pi).epsilon(rounding));
  CHECK(svg_area(R"(<polygon points="0,0 4,0 0,3"/>)") == Approx(6.0));
  CHECK(svg_area(R"(<path d="M0 0h4v3z"/>)") == Approx(6.0));
  // Half a disc by an arc; a parabola's segment, two thirds of its box; the cubic's likewise.
  CHECK(svg_area(R"(<path d="M-1 0A1 1 0 0 1 1 0z"/>)") == Approx(pi / 2).epsilon(rounding));
  CHECK(svg_area(R"(<path d="M0 0Q1 2 2 0z"/>)") == Approx(4.0 / 3.0).epsilon(rounding));
  CHECK(svg_area(R"(<path d="M0 0C0 1 1 1 1 0z"/>)") == Approx(0.6).epsilon(rounding));
}

TEST_CASE("all four arcs between two points are those of SVG") {
  const double pi = std::numbers::pi;
  const double rounding = 10 * flattening_tolerance;
  const double small = pi / 4 - 0.5;  // of a unit circle, cut by the chord of a right angle
  const auto with_flags = [](const std::string& flags) {
    return svg_area("<path d=\"M1 0A1 1 0 " + flags + " 0 1z\"/>");
  };
  CHECK(with_flags("0 0") == Approx(small).epsilon(rounding));
  CHECK(with_flags("0 1") == Approx(small).epsilon(rounding));
  CHECK(with_flags("1 0") == Approx(pi - small).epsilon(rounding));
  CHECK(with_flags("1 1") == Approx(pi - small).epsilon(rounding));
}

TEST_CASE("the points of a turned elliptical arc lie on its ellipse") {
  const Eigen::Vector2d center(4.0, 5.0);
  const Eigen::Rotation2Dd rotation(0.3);
  const Eigen::Vector2d radii(3.0, 1.0);
  Outline outline = {center + rotation * Eigen::Vector2d(3.0, 0.0)};
  add_arc({.radii = radii,
           .rotation = 0.3,
           .is_large = false,
           .is_sweep = true,
           .end = center + rotation * Eigen::Vector2d(0.0, 1.0)},
          outline);
  REQUIRE(outline.size() > 100);
  for (const Eigen::Vector2d& point : outline) {
    const Eigen::Vector2d local = rotation.inverse() * (point - center);
    CHECK(local.cwiseQuotient(radii).norm() == Approx(1.0).epsilon(1e-9));
    CHECK(local.minCoeff() > -1e-9);
  }
}

TEST_CASE("transforms of groups and shapes are applied") {
  CHECK(svg_area(R"svg(<g transform="scale(2)"><g transform="translate(3 4) rotate(30)">
                       <rect width="1" height="2" transform="scale(1 5)"/></g></g>)svg") ==
        Approx(2 * 2 * 5 * 2.0));
}

TEST_CASE("a smaller shape within a larger one is a hole") {
  CHECK(svg_area(R"(<rect width="4" height="3"/><rect x="1" y="1" width="1" height="1"/>)") ==
        Approx(11.0));
  CHECK(svg_area(R"(<path d="M0 0h4v3h-4z m1 1h1v1h-1z"/>)") == Approx(11.0));
}

TEST_CASE("what a drawing has beside its shapes is ignored") {
  CHECK(svg_area(R"(<defs><rect width="9" height="9"/></defs><text x="1">9</text><odd a="1"/>
                    <rect data-name="a" odd="b" width="4" height="3" style="fill:none;-x-odd:1"/>
                    <line x2="3"/><path d="M7 7h3"/>)") == Approx(12.0));
}

TEST_CASE("damaged drawings are refused with a reason") {
  CHECK_THROWS_WITH(read_svg("<html/>"), "it is no SVG document");
  CHECK_THROWS_WITH(read_svg("<svg><rect"), Catch::StartsWith("damaged XML: "));
  CHECK_THROWS_WITH(svg_area(R"(<path d="M0 0h4vz"/>)"), Catch::StartsWith("damaged SVG: "));
  CHECK_THROWS_WITH(svg_area(R"(<rect width="a" height="1"/>)"),
                    Catch::StartsWith("damaged SVG: "));
  CHECK_THROWS_WITH(svg_area(""), "there is no outline with an area");
}

TEST_CASE("every cut of a drawing is read or refused") {
  const std::string text =
      svg(R"svg(<g transform="scale(2)"><circle r="3"/><path d="M0 0h4v3z"/></g>)svg");
  int refused = 0;
  for (std::size_t size = 0; size < text.size(); ++size) {
    try {
      read_svg(text.substr(0, size));
    } catch (const InvalidInput&) {
      ++refused;
    }
  }
  CHECK(refused == static_cast<int>(text.size()));
}

TEST_CASE("well-known texts of polygons are read") {
  CHECK(area(simplify(read_wkt("POLYGON((0 0,4 0,4 3,0 3,0 0),(1 1,2 1,2 2,1 2,1 1))"))) ==
        Approx(11.0));
  CHECK(area(simplify(read_wkt(" multipolygon(((0 0,4 0,4 3)),((10 0,11 0,11 1,10 1)))\n"))) ==
        Approx(7.0));
  for (const char* text : {"POINT(1 2)", "POLYGON((0 0,1", "", "POLYGON((a b, c d))", "words"}) {
    CHECK_THROWS_WITH(read_wkt(text), "it is no well-known text of a POLYGON or MULTIPOLYGON");
  }
}

TEST_CASE("the record of a drawing says what it is") {
  const TemporaryDirectory directory;
  const auto path = directory.write("a.SVG", svg(R"(<rect width="4" height="3"/>)"));
  const Shape shape = load_shape(path, {});
  CHECK(shape.format == "svg");
  CHECK(shape.representation == "planar domain");
  CHECK(
      shape.statistics ==
      R"({"unit":"unknown","outlines_read":1,"outlines":1,"vertices":4,"area":12.0,"inside":"even-odd rule"})");
  CHECK(shape.field->enclosing_ball().radius == Approx(2.5));
}
