#include "features/core/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <catch2/catch.hpp>

namespace mdbd::test {

TEST_CASE("random numbers are those of the standard's generator") {
  // The 10000th number of a std::mt19937_64 begun with 5489 is fixed: 9981545732273789042.
  Random random(5489);
  for (int i = 1; i < 10'000; ++i) random.uniform();
  CHECK(random.uniform() == static_cast<double>(9981545732273789042U >> 11) * 0x1p-53);
}

TEST_CASE("uniform numbers fill their range evenly") {
  Random random(1);
  std::array<int, 10> counts{};
  for (int i = 0; i < 100'000; ++i) {
    const double x = random.uniform(-3, 2);
    REQUIRE(x >= -3);
    REQUIRE(x < 2);
    ++counts[static_cast<std::size_t>((x + 3) * 2)];
  }
  for (const int count : counts) CHECK(std::abs(count - 10'000) < 500);  // 5 standard deviations
}

TEST_CASE("indices are even, whatever their number") {
  Random random(2);
  CHECK(random.index(1) == 0);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70'000; ++i) ++counts.at(random.index(counts.size()));
  for (const int count : counts) CHECK(std::abs(count - 10'000) < 500);
  // Of 3/4 of all numbers, the lower third comes in one draw of three; a plain remainder would
  // give it in one of two.
  const std::size_t many = std::size_t{3} << 62;
  int low = 0;
  for (int i = 0; i < 30'000; ++i) low += random.index(many) < many / 3 ? 1 : 0;
  CHECK(std::abs(low - 10'000) < 400);
}

TEST_CASE("derived seeds depend on seed and text and are fixed") {
  CHECK(derive_seed(1, "chair/12.off") == derive_seed(1, "chair/12.off"));
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    for (int i = 0; i < 50; ++i) seeds.insert(derive_seed(seed, "chair/" + std::to_string(i)));
    seeds.insert(derive_seed(seed, ""));
  }
  CHECK(seeds.size() == 50 * 51);
  CHECK(derive_seed(1, "\xff") != derive_seed(1, "\x7f"));
}

}  // namespace mdbd::test
