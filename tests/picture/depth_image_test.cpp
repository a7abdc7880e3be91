#include "picture/depth_image.h"

#include <catch2/catch.hpp>

using mdbd::DepthImage;

namespace {

int count_covered(const DepthImage& image) {
  int covered = 0;
  for (int row = 0; row < image.size(); ++row) {
    for (int column = 0; column < image.size(); ++column) {
      covered += image.brightness(column, row) != DepthImage::nothing;
    }
  }
  return covered;
}

}  // namespace

TEST_CASE("a triangle covers its area, from either side") {
  DepthImage image(100);
  image.draw_triangle({{{10, 10, 0}, {90, 10, 0}, {10, 90, 0}}});
  CHECK(count_covered(image) == Approx(3200).margin(50));
  DepthImage back(100);
  back.draw_triangle({{{10, 10, 0}, {10, 90, 0}, {90, 10, 0}}});
  CHECK(count_covered(back) == count_covered(image));
  CHECK(back.brightness(20, 80) == image.brightness(20, 80));
  CHECK(image.brightness(80, 20) == DepthImage::nothing);
}

TEST_CASE("a ball covers a disc, and so does a disc that faces the viewer") {
  constexpr double area = 3.14159265 * 40 * 40;
  DepthImage ball(100);
  ball.draw_ball({50, 50, 0}, 40);
  CHECK(count_covered(ball) == Approx(area).epsilon(0.01));
  DepthImage disc(100);
  disc.draw_disc({50, 50, 0}, {0, 0, -3}, 40);
  CHECK(count_covered(disc) == count_covered(ball));
  DepthImage oblique(100);
  oblique.draw_disc({50, 50, 0}, {1, 0, 1}, 40);
  CHECK(count_covered(oblique) == Approx(area * 0.7071).epsilon(0.02));
}

TEST_CASE("what is nearer hides the rest, in whatever order it is drawn") {
  const auto draw = [](bool is_ball_first) {
    DepthImage image(60);
    if (is_ball_first) image.draw_ball({30, 30, 0}, 10);
    image.draw_triangle({{{-100, -100, 5}, {200, -100, 5}, {30, 200, 5}}});
    if (!is_ball_first) image.draw_ball({30, 30, 0}, 10);
    return image;
  };
  const DepthImage first = draw(true);
  const DepthImage second = draw(false);
  for (int i = 0; i < 60; ++i) CHECK(first.brightness(i, 30) == second.brightness(i, 30));
  CHECK(first.brightness(30, 30) != first.brightness(1, 30));  // the ball's cap, 5 samples in front
  CHECK(first.brightness(20, 30) == first.brightness(1, 30));  // the plane hides its rim
}

TEST_CASE("outlines are where there is a step in depth") {
  DepthImage image(60);
  image.draw_triangle({{{-100, -100, 0}, {200, -100, 0}, {30, 200, 0}}});
  const float plane = image.brightness(5, 30);
  image.draw_triangle({{{20, 20, 30}, {40, 20, 30}, {30, 40, 30}}});
  image.draw_outlines(10);
  CHECK(image.brightness(5, 30) == plane);
  CHECK(image.brightness(30, 39) < plane);   // the lower edge of the nearer one
  CHECK(image.brightness(30, 35) == plane);  // its middle
}

TEST_CASE("what lies outside of an image is cut off") {
  DepthImage image(10);
  image.draw_ball({-50, 5, 0}, 20);
  image.draw_triangle({{{1e9, 1e9, 0}, {2e9, 1e9, 0}, {1e9, 2e9, 0}}});
  image.draw_triangle({{{0, 0, 0}, {5, 5, 0}, {9, 9, 0}}});
  CHECK(count_covered(image) == 0);
}
