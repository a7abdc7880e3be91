#include "report/axis.h"

#include <cmath>

#include <catch2/catch.hpp>

using mdbd::Axis;
using mdbd::format_tick;
using mdbd::make_linear_axis;
using mdbd::make_logarithmic_axis;

using Ticks = std::vector<double>;

TEST_CASE("linear ticks are round numbers that hold the range") {
  CHECK(make_linear_axis(0, 1, 6).ticks == Ticks{0, 0.2, 0.4, 0.6, 0.8, 1});
  CHECK(make_linear_axis(0.04, 0.93, 6).ticks == Ticks{0, 0.2, 0.4, 0.6, 0.8, 1});
  CHECK(make_linear_axis(3, 97, 6).ticks == Ticks{0, 20, 40, 60, 80, 100});
  CHECK(make_linear_axis(-1, 1, 6).ticks == Ticks{-1, -0.5, 0, 0.5, 1});
  CHECK(make_linear_axis(0, 0.3, 4).ticks == Ticks{0, 0.1, 0.2, 0.3});
  CHECK(make_linear_axis(101, 104, 5).ticks == Ticks{101, 102, 103, 104});
}

TEST_CASE("a linear axis holds its range, whatever it is, and has at most the ticks asked for") {
  for (const double scale : {1e-310, 1e-300, 3e-7, 1.0, 7.7, 4e12, 1e300, 1.7e308}) {
    for (const auto& [low, high] : {std::pair{0.0, 1.0},
                                    {-0.3, 0.9},
                                    {0.99, 1.0},
                                    {1.0, 1.0},
                                    {-1.0, -1.0},
                                    {0.5, 0.5 + 1e-14},
                                    {-1.0, 0.0}}) {
      for (const int most : {3, 4, 6, 9}) {
        const Axis axis = make_linear_axis(low * scale, high * scale, most);
        INFO(low << " to " << high << " times " << scale << ", at most " << most);
        CHECK(axis.lowest <= std::max(low * scale, -1e300));
        CHECK(axis.highest >= std::min(high * scale, 1e300));
        CHECK(axis.ticks.size() >= 2);
        CHECK(axis.ticks.size() <= static_cast<std::size_t>(most));
        CHECK(std::isfinite(axis.position(low * scale)));
        CHECK(axis.position(axis.ticks.back()) <= 1.0);
      }
    }
  }
  const Axis nothing = make_linear_axis(0, 0, 5);
  CHECK(nothing.lowest == 0);
  CHECK(nothing.highest == 1);
}

TEST_CASE("logarithmic ticks are round numbers at equal ratios") {
  CHECK(make_logarithmic_axis(1000, 20000, 9).ticks == Ticks{1000, 2000, 5000, 10000, 20000});
  CHECK(make_logarithmic_axis(0.01, 1e4, 9).ticks == Ticks{0.01, 0.1, 1, 10, 100, 1000, 1e4});
  CHECK(make_logarithmic_axis(5, 5, 9).ticks == Ticks{5, 10});
  const Axis axis = make_logarithmic_axis(1, 100, 9);
  CHECK(axis.position(1) == 0);
  CHECK(axis.position(10) == Approx(0.5));
  CHECK(axis.position(100) == 1);
  const Axis wide = make_logarithmic_axis(1e-290, 1e290, 9);
  CHECK(wide.ticks.size() >= 2);
  CHECK(wide.ticks.size() <= 9);
}

TEST_CASE("ticks are written without noise") {
  CHECK(format_tick(make_linear_axis(0, 0.3, 4).ticks[3]) == "0.3");
  CHECK(format_tick(-0.5) == "-0.5");
  CHECK(format_tick(100000) == "100000");
  CHECK(format_tick(1e-7) == "1e-07");
}
