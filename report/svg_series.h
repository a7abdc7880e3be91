#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace mdbd {

/// How the samples of a legend look.
enum class LegendKind { lines, bars };

/// The classes of the style sheet that give a series its colour and its dashes: no two of the first
/// forty series look the same.
std::string series_class(std::size_t number);

/// The names of series beside samples of them, as an HTML list. Empty for less than two series,
/// which need no telling apart.
std::string html_legend(std::span<const std::string> names, LegendKind kind);

}  // namespace mdbd
