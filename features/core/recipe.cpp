#include "features/core/recipe.h"

#include <algorithm>
#include <charconv>
#include <concepts>
#include <map>

#include "features/core/errors.h"

namespace mdbd {
namespace {

template <typename Number>
std::string number_to_text(Number value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(std::begin(buffer), std::end(buffer), value);
  return {buffer, error == std::errc() ? end : buffer};
}

template <typename Number>
void read_value(const std::string& name, const std::string& text, Number& value) {
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last) {
    throw InvalidInput("recipe: '" + text + "' is no value for " + name);
  }
}

void read_value(const std::string&, const std::string& text, std::string& value) { value = text; }

std::string value_to_text(const std::string& value) { return value; }
template <typename Number>
requires std::integral<Number> || std::floating_point<Number> std::string value_to_text(
    Number value) {
  return number_to_text(value);
}

// The one list of parameters: calls visit(name, member) for each.
template <typename RecipeType, typename Visitor>
void for_each_parameter(RecipeType& recipe, Visitor&& visit) {
  visit("algorithm_version", recipe.algorithm_version);
  visit("balls", recipe.balls);
  visit("radius_tolerance", recipe.radius_tolerance);
  visit("minimum_radius", recipe.minimum_radius);
  visit("descriptor_balls", recipe.descriptor_balls);
  visit("walk_steps", recipe.walk_steps);
  visit("walk_damping", recipe.walk_damping);
  visit("contact_tolerance", recipe.contact_tolerance);
  visit("walk_weight", recipe.walk_weight);
  visit("denoise", recipe.denoise);
  visit("solidify", recipe.solidify);
  visit("scaling", recipe.scaling);
}

void require(bool condition, const char* message) {
  if (!condition) throw InvalidInput(message);
}

}  // namespace

RecipeEntries to_entries(const Recipe& recipe) {
  RecipeEntries entries;
  for_each_parameter(recipe, [&](const char* name, const auto& value) {
    entries.emplace_back(name, value_to_text(value));
  });
  return entries;
}

Recipe recipe_from_entries(const RecipeEntries& entries) {
  std::map<std::string, std::string> remaining;
  for (const auto& [name, text] : entries) {
    if (!remaining.emplace(name, text).second) throw InvalidInput("recipe: " + name + " twice");
  }
  Recipe recipe;
  for_each_parameter(recipe, [&](const char* name, auto& value) {
    const auto entry = remaining.find(name);
    if (entry == remaining.end()) throw InvalidInput(std::string("recipe: no ") + name);
    read_value(name, entry->second, value);
    remaining.erase(entry);
  });
  if (!remaining.empty()) throw InvalidInput("recipe: unknown " + remaining.begin()->first);
  return recipe;
}

std::string describe_difference(const Recipe& left, const Recipe& right) {
  const RecipeEntries ours = to_entries(left);
  const RecipeEntries theirs = to_entries(right);
  std::string text;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (ours[i].second == theirs[i].second) continue;
    if (!text.empty()) text += ", ";
    text += ours[i].first + " " + ours[i].second + " against " + theirs[i].second;
  }
  return text;
}

void validate(const Recipe& recipe) {
  require(recipe.algorithm_version == current_algorithm_version,
          "made by another version of the algorithm, whose numbers cannot be compared");
  require(recipe.balls >= 1 && recipe.balls <= 100'000, "balls must be from 1 to 100000");
  require(recipe.radius_tolerance >= 1e-9 && recipe.radius_tolerance <= 0.5,
          "radius tolerance must be from 1e-9 to 0.5");
  require(recipe.minimum_radius > 0 && recipe.minimum_radius < 1,
          "minimum radius must be between 0 and 1");
  require(recipe.descriptor_balls >= 1 && recipe.descriptor_balls <= 100'000,
          "descriptor balls must be from 1 to 100000");
  require(recipe.walk_steps >= 0 && recipe.walk_steps <= 100'000,
          "walk steps must be from 0 to 100000");
  require(recipe.walk_damping > 0 && recipe.walk_damping <= 1,
          "walk damping must be above 0 and at most 1");
  require(recipe.contact_tolerance >= 0 && recipe.contact_tolerance < 1,
          "contact tolerance must be from 0 to below 1");
  require(recipe.walk_weight >= 0 && recipe.walk_weight < 1e6,
          "walk weight must be from 0 to below 1000000");
  require(recipe.denoise == "auto" || recipe.denoise == "off", "denoise must be auto or off");
  require(recipe.solidify == "auto" || recipe.solidify == "off", "solidify must be auto or off");
  require(recipe.scaling == "enclosing-ball", "scaling must be enclosing-ball");
}

}  // namespace mdbd
