#include "query/scalar_quantiser.h"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>

using namespace mdbd;

namespace {

constexpr std::size_t dimension = 6;

// Numbers of very different spread around `origin`, and now and then one that is far out.
std::vector<float> make_points(std::size_t rows, float scale, float origin) {
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  std::vector<float> points;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < dimension; ++i) {
      const float spread =
          scale / static_cast<float>(1U << i) * (random() % 50 == 0 ? 20.0F : 1.0F);
      points.push_back(origin + spread * normal(random));
    }
  }
  return points;
}

template <typename Left, typename Right>
double distance(const Left& left, const Right& right, PointNorm norm) {
  double sum = 0.0;
  for (std::size_t i = 0; i < dimension; ++i) {
    const double difference =
        std::abs(static_cast<double>(left[i]) - static_cast<double>(right[i]));
    sum += norm == PointNorm::l1 ? difference : difference * difference;
  }
  return norm == PointNorm::l1 ? sum : std::sqrt(sum);
}

}  // namespace

TEST_CASE("bytes are as far apart as their points, less what they are off") {
  const PointNorm norm = GENERATE(PointNorm::l1, PointNorm::l2);
  const auto [scale, origin] =
      GENERATE(std::pair(1.0F, 0.0F), std::pair(1e-30F, 0.0F), std::pair(1e15F, -1e16F),
               std::pair(1.0F, 1e6F), std::pair(0.0F, 3.0F));
  constexpr std::size_t rows = 200;
  const std::vector<float> points = make_points(rows, scale, origin);
  const ScalarQuantiser quantiser(points, dimension);
  REQUIRE(quantiser.step() > 0.0);
  std::vector<std::vector<float>> places(rows, std::vector<float>(dimension));
  std::vector<std::vector<std::uint8_t>> bytes(rows, std::vector<std::uint8_t>(dimension));
  std::vector<double> errors;
  const auto point = [&](std::size_t row) {
    return std::span(points).subspan(row * dimension, dimension);
  };
  for (std::size_t row = 0; row < rows; ++row) {
    quantiser.locate(point(row), places[row]);
    errors.push_back(ScalarQuantiser::write(places[row], norm, bytes[row]));
    CHECK(errors[row] == Approx(distance(places[row], bytes[row], norm)));
    CHECK(errors[row] <= (norm == PointNorm::l1 ? 0.5 * dimension : 0.5 * std::sqrt(dimension)));
  }
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double steps = distance(point(i), point(j), norm) / quantiser.step();
      const double of_places = distance(places[i], places[j], norm);
      const double of_bytes = distance(bytes[i], bytes[j], norm);
      if (of_places > steps + quantiser.rounding()) FAIL_CHECK(of_places << " > " << steps);
      if (of_bytes > of_places + errors[i] + errors[j]) FAIL_CHECK(of_bytes << " > " << of_places);
    }
  }
}

TEST_CASE("most points are within the lattice, in small steps") {
  const std::vector<float> points = make_points(1000, 1.0F, 0.0F);
  const ScalarQuantiser quantiser(points, dimension);
  std::size_t inside = 0;
  std::vector<float> place(dimension);
  for (std::size_t first = 0; first < points.size(); first += dimension) {
    quantiser.locate(std::span(points).subspan(first, dimension), place);
    for (const float coordinate : place) inside += coordinate > 0.0F && coordinate < 255.0F ? 1 : 0;
  }
  CHECK(inside > points.size() * 9 / 10);
  CHECK(quantiser.step() < 0.1);
}

TEST_CASE("a quantiser is what its step and corner say") {
  const std::vector<float> points = make_points(50, 1.0F, 2.0F);
  const ScalarQuantiser quantiser(points, dimension);
  const ScalarQuantiser same(quantiser.step(),
                             {quantiser.corner().begin(), quantiser.corner().end()});
  std::vector<float> before(dimension);
  std::vector<float> after(dimension);
  for (std::size_t first = 0; first < points.size(); first += dimension) {
    quantiser.locate(std::span(points).subspan(first, dimension), before);
    same.locate(std::span(points).subspan(first, dimension), after);
    CHECK(before == after);
  }
}
