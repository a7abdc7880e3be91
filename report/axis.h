#pragma once

#include <string>
#include <vector>

namespace mdbd {

/// The scale of one axis of a chart. Its ends and its ticks are round numbers.
struct Axis {
  double lowest = 0.0;
  double highest = 1.0;
  std::vector<double> ticks;  ///< ascending
  bool is_logarithmic = false;

  /// Where a value lies along the axis: 0 at its lowest, 1 at its highest value.
  double position(double value) const;
};

/// An axis that holds two values, with ticks at multiples of 1, 2 or 5 times a power of ten. It
/// begins and ends at a tick. Equal values get room around them.
/// @pre the values are finite, and most_ticks >= 3
Axis make_linear_axis(double lowest, double highest, int most_ticks);

/// A logarithmic axis that holds two values, with ticks at 1, 2 or 5 times powers of ten, or at
/// (some) powers of ten only where those would be too many.
/// @pre 0 < lowest <= highest < infinity, and most_ticks >= 3
Axis make_logarithmic_axis(double lowest, double highest, int most_ticks);

/// A tick for people: "0.25", "100", "1e-05".
std::string format_tick(double value);

}  // namespace mdbd
