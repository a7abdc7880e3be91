#include "report/svg_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "cli/utf8.h"
#include "report/markup.h"

namespace mdbd {
namespace {

constexpr double letter_width = 6.6;  ///< on average, of the style sheet's font for pictures
constexpr double line_height = 16.0;
constexpr std::size_t longest_label = 18;  ///< characters

std::string_view name_of(Anchor anchor) {
  switch (anchor) {
    case Anchor::start:
      return "start";
    case Anchor::middle:
      return "middle";
    case Anchor::end:
      return "end";
  }
  return "";
}

}  // namespace

std::string format_length(double length) {
  return fmt::format("{:.10g}", std::round(length * 100.0) / 100.0 + 0.0);
}

std::string svg_element(double width, double height, std::string_view label,
                        std::string_view content) {
  const std::string w = format_length(width);
  const std::string h = format_length(height);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" "
      "role=\"img\" aria-label=\"{}\">\n{}</svg>\n",
      w, h, w, h, escape_markup(label), content);
}

double text_width(std::string_view text) {
  return letter_width * static_cast<double>(display_width(text));
}

std::string svg_text(double x, double y, Anchor anchor, std::string_view text) {
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", format_length(x),
                     format_length(y), name_of(anchor), escape_markup(text));
}

std::optional<Range> finite_range(std::span<const double> values, std::optional<Range> so_far) {
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    so_far = so_far ? Range{std::min(so_far->lowest, value), std::max(so_far->highest, value)}
                    : Range{value, value};
  }
  return so_far;
}

std::string svg_y_axis(const PlotArea& area, const Axis& axis) {
  std::string svg;
  for (const double tick : axis.ticks) {
    const double y = area.y(axis.position(tick));
    const bool is_base = tick == 0.0 || y == area.bottom();
    svg += fmt::format("<path class=\"{}\" d=\"M{} {}H{}\"/>\n", is_base ? "base" : "grid",
                       format_length(area.left), format_length(y), format_length(area.right()));
    svg += svg_text(area.left - 8.0, y + 4.0, Anchor::end, format_tick(tick));
  }
  return svg;
}

std::string svg_x_axis(const PlotArea& area, const Axis& axis, std::string_view label) {
  std::string svg;
  for (const double tick : axis.ticks) {
    const double x = area.x(axis.position(tick));
    svg += fmt::format("<path class=\"base\" d=\"M{} {}v5\"/>\n", format_length(x),
                       format_length(area.bottom()));
    svg += svg_text(x, area.bottom() + 19.0, Anchor::middle, format_tick(tick));
  }
  return svg + svg_text(area.x(0.5), area.bottom() + 40.0, Anchor::middle, label);
}

StretchLabels svg_stretch_labels(double top, std::span<const StretchLabel> labels) {
  double widest = 0.0;
  bool is_slanted = false;
  for (const StretchLabel& label : labels) {
    const double width = text_width(shorten(label.text, longest_label));
    widest = std::max(widest, width);
    is_slanted = is_slanted || width > label.width;
  }
  StretchLabels result;
  double free_from = -std::numeric_limits<double>::infinity();
  for (const StretchLabel& label : labels) {
    if (label.middle < free_from) continue;
    const std::string text = shorten(label.text, longest_label);
    if (is_slanted) {
      result.svg += fmt::format("<g transform=\"translate({} {}) rotate(-45)\">{}</g>\n",
                                format_length(label.middle + 4.0), format_length(top + 12.0),
                                svg_text(0.0, 0.0, Anchor::end, text));
      free_from = label.middle + line_height;
    } else {
      result.svg += svg_text(label.middle, top + 16.0, Anchor::middle, text);
    }
  }
  if (!labels.empty()) result.height = is_slanted ? 18.0 + widest * 0.71 : 22.0;
  return result;
}

std::vector<BandStretch> band_stretches(std::span<const Band> bands, std::size_t count) {
  std::vector<BandStretch> stretches;
  std::size_t start = 0;
  for (const Band& band : bands) {
    const std::size_t end = start + std::min(band.count, count - start);
    if (end == start) continue;
    stretches.push_back({band.name, static_cast<double>(start) / static_cast<double>(count),
                         static_cast<double>(end) / static_cast<double>(count)});
    start = end;
  }
  return stretches;
}

std::vector<StretchLabel> band_labels(std::span<const BandStretch> stretches,
                                      const PlotArea& area) {
  std::vector<StretchLabel> labels;
  for (const BandStretch& band : stretches) {
    labels.push_back(
        {area.x((band.start + band.end) / 2.0), (band.end - band.start) * area.width, band.name});
  }
  return labels;
}

}  // namespace mdbd
