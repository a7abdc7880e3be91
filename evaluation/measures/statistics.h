#pragma once

#include <optional>
#include <span>
#include <vector>

namespace mdbd {

/// @pre values is not empty
double mean(std::span<const double> values);

/// The value below which a share of the values lies, interpolated between neighbours (type 7 of
/// Hyndman and Fan, Sample quantiles in statistical packages, 1996).
/// @pre values is not empty; 0 <= share <= 1
double quantile(std::vector<double> values, double share);

/// Spearman's rank correlation, from -1 to 1; equal values share the mean of their ranks. Undefined
/// if all values of a side are equal or there are fewer than two.
/// @pre both have the same size
std::optional<double> rank_correlation(std::span<const double> a, std::span<const double> b);

}  // namespace mdbd
