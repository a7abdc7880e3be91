#include "report/svg_series.h"

#include <string_view>

#include <fmt/format.h>

#include "report/markup.h"

namespace mdbd {
namespace {

constexpr std::size_t colours = 8;  ///< of the style sheet
constexpr std::size_t dashes = 5;   ///< of the style sheet; shares no factor with the colours

constexpr std::string_view line_sample =
    "<svg width=\"30\" height=\"10\" viewBox=\"0 0 30 10\" aria-hidden=\"true\">"
    "<path class=\"line\" d=\"M2 5H28\"/></svg>";
constexpr std::string_view bar_sample =
    "<svg width=\"11\" height=\"11\" viewBox=\"0 0 11 11\" aria-hidden=\"true\">"
    "<path class=\"bar\" d=\"M0 0h11v11h-11z\"/></svg>";

}  // namespace

std::string series_class(std::size_t number) {
  return fmt::format("colour-{} dash-{}", number % colours, number % dashes);
}

std::string html_legend(std::span<const std::string> names, LegendKind kind) {
  if (names.size() < 2) return "";
  std::string html = "<ul class=\"legend\">\n";
  for (std::size_t i = 0; i < names.size(); ++i) {
    html +=
        fmt::format("<li class=\"{}\">{}<span>{}</span></li>\n", series_class(i),
                    kind == LegendKind::lines ? line_sample : bar_sample, escape_markup(names[i]));
  }
  return html + "</ul>\n";
}

}  // namespace mdbd
