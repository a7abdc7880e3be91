#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace mdbd {

/// A unit of length by the name that options and records use.
struct LengthUnit {
  std::string_view name;
  double millimetres;
};

inline constexpr std::array<LengthUnit, 5> length_units{
    {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"inch", 25.4}, {"ft", 304.8}}};

/// The millimetres of a unit; none if there is no unit of that name.
constexpr std::optional<double> millimetres_of(std::string_view name) {
  for (const LengthUnit& unit : length_units) {
    if (unit.name == name) return unit.millimetres;
  }
  return std::nullopt;
}

}  // namespace mdbd
