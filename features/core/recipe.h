#pragma once

#include <string>
#include <utility>
#include <vector>

#include "features/core/signature.h"

namespace mdbd {

/// Raised whenever the same parameters give other numbers than before.
inline constexpr int current_algorithm_version = 6;

/// Every parameter that changes numbers. A database holds vectors of one recipe only; vectors of
/// different recipes are never compared.
struct Recipe {
  int algorithm_version = current_algorithm_version;
  int balls = 500;                  ///< n, how many balls are placed at most
  double radius_tolerance = 1e-3;   ///< epsilon, relative to the radius of the ball placed
  double minimum_radius = 1e-3;     ///< smaller balls are not placed; relative to R
  int descriptor_balls = 50;        ///< k, how many radii enter the descriptor
  int walk_steps = 50;              ///< m, how many steps the random walk takes
  double walk_damping = 0.9;        ///< lambda, damps the walk sum of step t by lambda^t
  double contact_tolerance = 1e-3;  ///< tau, relative to the smaller of two radii
  double walk_weight = 1.0;         ///< alpha, weight of the walk part in the similarity distance
  /// What is done to noisy input: "auto" takes noise that stands out from meshes, "off" nothing.
  std::string denoise = "auto";
  /// What is done to surfaces that enclose nothing: "auto" gives them a thickness, "off" refuses
  /// them.
  std::string solidify = "auto";
  std::string scaling = "enclosing-ball";  ///< radii are divided by R

  bool operator==(const Recipe&) const = default;
};

/// One parameter by its name in the store and in messages, with its exact value as text.
using RecipeEntries = std::vector<std::pair<std::string, std::string>>;

/// The recipe as text. Doubles are written in the shortest form that reads back to the same bits.
RecipeEntries to_entries(const Recipe& recipe);

/// The inverse of to_entries; the order of the entries is free.
/// @throws InvalidInput if an entry is missing, unknown, malformed or given twice
Recipe recipe_from_entries(const RecipeEntries& entries);

/// The parameters in which two recipes differ, for people: "balls 500 against 300, …".
/// Empty if they are equal.
std::string describe_difference(const Recipe& left, const Recipe& right);

/// Checks that every parameter is in its range and that this program has the algorithm.
/// @throws InvalidInput naming the parameter
void validate(const Recipe& recipe);

}  // namespace mdbd
