#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mdbd {

/// The unit of coordinates of files whose format has none. Nothing is guessed.
inline constexpr std::string_view unknown_unit = "unknown";

/// Notes the unit of the coordinates in the record of a shape that has none; others stay as they
/// are.
/// @param statistics the JSON object of a Shape
/// @param unit one of length_units
std::string declare_unit(const std::string& statistics, std::string_view unit);

/// The millimetres of a shape's unit of coordinates; none if its record does not say.
/// @param statistics the JSON object of a Shape, or empty
std::optional<double> recorded_millimetres(const std::string& statistics);

}  // namespace mdbd
