#include "features/descriptor/similarity_distance.h"

#include <cmath>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

using namespace mdbd;

namespace {

std::vector<float> random_vector(std::mt19937& random) {
  std::uniform_real_distribution<float> value(0.0F, 1.0F);
  std::vector<float> vector(100);
  for (float& x : vector) x = value(random);
  return vector;
}

double total(const std::vector<float>& f, const std::vector<float>& g, double weight = 1.0) {
  return similarity_distance(f, g, 50, weight).total;
}

}  // namespace

TEST_CASE("the similarity distance adds the norms of its two parts") {
  const std::vector<float> f{3, 0, 0, 0};
  const std::vector<float> g{0, 4, 6, 8};
  const SimilarityDistance distance = similarity_distance(f, g, 2, 0.5);
  CHECK(distance.radii == Approx(5.0));
  CHECK(distance.walk == Approx(10.0));
  CHECK(distance.total == Approx(10.0));
}

TEST_CASE("the similarity distance is a metric between L2 and sqrt(2) L2") {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const std::vector<float> f = random_vector(random);
    const std::vector<float> g = random_vector(random);
    const std::vector<float> h = random_vector(random);
    CHECK(total(f, f) == 0.0);
    CHECK(total(f, g) == total(g, f));
    CHECK(total(f, h) <= total(f, g) + total(g, h) + 1e-12);
    double squared = 0.0;
    for (std::size_t i = 0; i < f.size(); ++i) squared += std::pow(double{f[i]} - double{g[i]}, 2);
    CHECK(std::sqrt(squared) <= total(f, g) + 1e-12);
    CHECK(total(f, g) <= std::sqrt(2 * squared) + 1e-12);
  }
}
