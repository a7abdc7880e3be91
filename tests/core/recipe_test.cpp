#include "features/core/recipe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "features/core/errors.h"

using namespace mdbd;
using Catch::Matchers::Contains;

namespace {

Recipe make_other_recipe() {
  Recipe recipe;
  recipe.algorithm_version = 3;
  recipe.balls = 300;
  recipe.radius_tolerance = 0.1;
  recipe.minimum_radius = 1.0 / 3.0;
  recipe.descriptor_balls = 20;
  recipe.walk_steps = 0;
  recipe.walk_damping = std::nextafter(0.9, 1.0);
  recipe.contact_tolerance = std::numeric_limits<double>::denorm_min();
  recipe.walk_weight = 1e5 + 1e-9;
  recipe.denoise = "off";
  recipe.solidify = "off";
  return recipe;
}

std::string error_of(const RecipeEntries& entries) {
  try {
    recipe_from_entries(entries);
    return {};
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

std::string value_of(const RecipeEntries& entries, const std::string& name) {
  for (const auto& [entry, value] : entries) {
    if (entry == name) return value;
  }
  return "nothing";
}

}  // namespace

TEST_CASE("a recipe comes back from its entries to the bit") {
  for (const Recipe& recipe : {Recipe{}, make_other_recipe()}) {
    CHECK(recipe_from_entries(to_entries(recipe)) == recipe);
  }
}

// Recipes are compared with what older programs stored: names and texts must not change.
TEST_CASE("the entries of the default recipe are these") {
  const RecipeEntries expected = {
      {"algorithm_version", "6"},    {"balls", "500"},
      {"radius_tolerance", "0.001"}, {"minimum_radius", "0.001"},
      {"descriptor_balls", "50"},    {"walk_steps", "50"},
      {"walk_damping", "0.9"},       {"contact_tolerance", "0.001"},
      {"walk_weight", "1"},          {"denoise", "auto"},
      {"solidify", "auto"},          {"scaling", "enclosing-ball"},
  };
  CHECK(to_entries(Recipe{}) == expected);
}

TEST_CASE("the order of entries is free") {
  RecipeEntries entries = to_entries(make_other_recipe());
  std::reverse(entries.begin(), entries.end());
  CHECK(recipe_from_entries(entries) == make_other_recipe());
}

TEST_CASE("an entry that is missing is named") {
  const RecipeEntries whole = to_entries(Recipe{});
  for (std::size_t i = 0; i < whole.size(); ++i) {
    RecipeEntries entries = whole;
    entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK_THAT(error_of(entries), Contains(whole[i].first));
  }
  CHECK_FALSE(error_of({}).empty());
}

TEST_CASE("an entry that is unknown or given twice is named") {
  RecipeEntries entries = to_entries(Recipe{});
  entries.emplace_back("colour", "red");
  CHECK_THAT(error_of(entries), Contains("colour"));
  entries.back() = {"balls", "500"};
  CHECK_THAT(error_of(entries), Contains("balls"));
}

TEST_CASE("a malformed value is named with its entry") {
  const std::string name = GENERATE("balls", "radius_tolerance");
  const std::string value =
      GENERATE("", " 5", "5 ", "five", "5x", "1e", "0x5", "+5", "99999999999e999", "5,0");
  RecipeEntries entries = to_entries(Recipe{});
  for (auto& entry : entries) {
    if (entry.first == name) entry.second = value;
  }
  CHECK_THAT(error_of(entries), Contains("'" + value + "'") && Contains(name));
}

TEST_CASE("whole numbers take no fractions and no overflow") {
  const std::string value = GENERATE("5.0", "1e3", "2147483648", "-2147483649");
  RecipeEntries entries = to_entries(Recipe{});
  for (auto& entry : entries) {
    if (entry.first == "balls") entry.second = value;
  }
  CHECK_THAT(error_of(entries), Contains("balls"));
}

TEST_CASE("doubles are written in the shortest exact form") {
  Recipe recipe;
  recipe.walk_damping = 0.1;
  CHECK(value_of(to_entries(recipe), "walk_damping") == "0.1");
  recipe.walk_damping = std::nextafter(0.1, 1.0);
  CHECK(value_of(to_entries(recipe), "walk_damping") == "0.10000000000000002");
}

TEST_CASE("differences are told for people") {
  Recipe left;
  Recipe right;
  CHECK(describe_difference(left, right).empty());
  right.balls = 300;
  CHECK(describe_difference(left, right) == "balls 500 against 300");
  right.walk_damping = 0.8;
  CHECK(describe_difference(left, right) == "balls 500 against 300, walk_damping 0.9 against 0.8");
  CHECK(describe_difference(right, left) == "balls 300 against 500, walk_damping 0.8 against 0.9");
}

TEST_CASE("every parameter has its range") {
  const double nan = std::nan("");
  const auto is_valid = [](auto Recipe::*parameter, auto value) {
    Recipe recipe;
    recipe.*parameter = value;
    try {
      validate(recipe);
      return true;
    } catch (const InvalidInput&) {
      return false;
    }
  };
  CHECK_NOTHROW(validate(Recipe{}));
  for (const int balls : {1, 100'000}) CHECK(is_valid(&Recipe::balls, balls));
  for (const int balls : {0, -1, 100'001}) CHECK_FALSE(is_valid(&Recipe::balls, balls));
  for (const int count : {1, 100'000}) CHECK(is_valid(&Recipe::descriptor_balls, count));
  for (const int count : {0, 100'001}) CHECK_FALSE(is_valid(&Recipe::descriptor_balls, count));
  for (const int steps : {0, 100'000}) CHECK(is_valid(&Recipe::walk_steps, steps));
  for (const int steps : {-1, 100'001}) CHECK_FALSE(is_valid(&Recipe::walk_steps, steps));
  for (const double x : {1e-9, 0.5}) CHECK(is_valid(&Recipe::radius_tolerance, x));
  for (const double x : {0.0, -1.0, 0.6, nan}) CHECK_FALSE(is_valid(&Recipe::radius_tolerance, x));
  for (const double x : {1e-9, 0.999}) CHECK(is_valid(&Recipe::minimum_radius, x));
  for (const double x : {0.0, 1.0, nan}) CHECK_FALSE(is_valid(&Recipe::minimum_radius, x));
  for (const double x : {1e-9, 1.0}) CHECK(is_valid(&Recipe::walk_damping, x));
  for (const double x : {0.0, 1.1, nan}) CHECK_FALSE(is_valid(&Recipe::walk_damping, x));
  for (const double x : {0.0, 0.999}) CHECK(is_valid(&Recipe::contact_tolerance, x));
  for (const double x : {-1e-9, 1.0, nan}) CHECK_FALSE(is_valid(&Recipe::contact_tolerance, x));
  for (const double x : {0.0, 999'999.0}) CHECK(is_valid(&Recipe::walk_weight, x));
  for (const double x : {-1.0, 1e6, HUGE_VAL, nan}) CHECK_FALSE(is_valid(&Recipe::walk_weight, x));
  CHECK(is_valid(&Recipe::denoise, std::string("off")));
  CHECK_FALSE(is_valid(&Recipe::denoise, std::string("always")));
  CHECK(is_valid(&Recipe::solidify, std::string("off")));
  CHECK_FALSE(is_valid(&Recipe::solidify, std::string("always")));
  CHECK_FALSE(is_valid(&Recipe::scaling, std::string("volume")));
}

TEST_CASE("a recipe of another algorithm is refused") {
  mdbd::Recipe recipe;
  recipe.algorithm_version = mdbd::current_algorithm_version + 1;
  CHECK_THROWS_AS(mdbd::validate(recipe), mdbd::InvalidInput);
}
