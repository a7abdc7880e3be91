#include "report/axis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace mdbd {
namespace {

constexpr std::array mantissas = {1, 2, 5};

/// Round numbers in order, by number: …, 0.5, 1, 2, 5, 10, … for -1, 0, 1, 2, 3.
double round_number(int number) {
  const int decade = number >= 0 ? number / 3 : -((2 - number) / 3);
  const int mantissa = mantissas[static_cast<std::size_t>(number - 3 * decade)];
  return decade >= 0 ? mantissa * std::pow(10.0, decade) : mantissa / std::pow(10.0, -decade);
}

/// The number of the largest round number that is not above a value.
int round_number_below(double value) {
  int number = 3 * static_cast<int>(std::floor(std::log10(value))) + 3;
  while (round_number(number) > value * (1.0 + 1e-12)) --number;
  return number;
}

/// A multiple of a round number, rounded once only: 3 · 0.1 is 0.3.
double multiple(double count, int number) {
  const double step = round_number(number);
  return step < 1.0 ? count / std::round(1.0 / step) : count * step;
}

Axis axis_with_step(double lowest, double highest, int number) {
  const double step = round_number(number);
  const double slack = 1e-9;  // of a step: rounding must not add a tick
  const double first = std::floor(lowest / step + slack);
  const double last = std::ceil(highest / step - slack);
  Axis axis;
  for (double count = first; count <= last; ++count) {
    axis.ticks.push_back(multiple(count, number) + 0.0);
  }
  axis.lowest = std::min(axis.ticks.front(), lowest);
  axis.highest = std::max(axis.ticks.back(), highest);
  return axis;
}

}  // namespace

double Axis::position(double value) const {
  if (is_logarithmic) return std::log(value / lowest) / std::log(highest / lowest);
  return (value - lowest) / (highest - lowest);
}

Axis make_linear_axis(double lowest, double highest, int most_ticks) {
  constexpr double largest = 1e300;
  lowest = std::clamp(lowest, -largest, largest);
  highest = std::clamp(highest, -largest, largest);
  const double size = std::max({std::abs(lowest), std::abs(highest), 1.0 / largest});
  if (highest - lowest <= 1e-9 * size) {
    const double room = lowest == 0.0 && highest == 0.0 ? 1.0 : 0.1 * size;
    highest += room;
    if (lowest != 0.0) lowest -= room;
  }
  int number = round_number_below((highest - lowest) / most_ticks);
  Axis axis = axis_with_step(lowest, highest, number);
  while (axis.ticks.size() > static_cast<std::size_t>(most_ticks)) {
    axis = axis_with_step(lowest, highest, ++number);
  }
  return axis;
}

Axis make_logarithmic_axis(double lowest, double highest, int most_ticks) {
  const int first = round_number_below(lowest);
  int last = round_number_below(highest);
  if (round_number(last) < highest * (1.0 - 1e-12) || last == first) ++last;
  Axis axis;
  axis.is_logarithmic = true;
  axis.lowest = round_number(first);
  axis.highest = round_number(last);
  for (int stride = 1; axis.ticks.empty(); stride += stride == 1 ? 2 : 3) {
    for (int number = first; number <= last; ++number) {
      if (number % stride == 0) axis.ticks.push_back(round_number(number));
    }
    if (axis.ticks.size() > static_cast<std::size_t>(most_ticks)) axis.ticks.clear();
  }
  return axis;
}

std::string format_tick(double value) { return fmt::format("{:.10g}", value); }

}  // namespace mdbd
