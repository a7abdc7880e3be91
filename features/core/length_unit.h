#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace mdbd {

/// A unit of length by the name that options use, and by its word in file formats.
struct LengthUnit {
  std::string_view name;
  std::string_view word;
  double millimetres;
};

inline constexpr std::array<LengthUnit, 6> length_units{{{"micron", "micron", 0.001},
                                                         {"mm", "millimeter", 1.0},
                                                         {"cm", "centimeter", 10.0},
                                                         {"m", "meter", 1000.0},
                                                         {"inch", "inch", 25.4},
                                                         {"ft", "foot", 304.8}}};

/// The millimetres of a unit; none if there is no unit of that name or word.
constexpr std::optional<double> millimetres_of(std::string_view name) {
  for (const LengthUnit& unit : length_units) {
    if (unit.name == name || unit.word == name) return unit.millimetres;
  }
  return std::nullopt;
}

}  // namespace mdbd
