#include "report/svg_bar_chart.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "report/axis.h"
#include "report/markup.h"
#include "report/svg_frame.h"
#include "report/svg_series.h"

namespace mdbd {
namespace {

constexpr double left = 64.0;
constexpr double top = 30.0;
constexpr double width = 820.0;
constexpr double widest_group = 110.0;   ///< few bars need not fill the page
constexpr double narrowest_bar = 2.5;    ///< for bars side by side
constexpr std::size_t most_names = 48;   ///< of categories below the bars
constexpr double single_height = 300.0;  ///< of the area with all series
constexpr double panel_height = 130.0;   ///< of the area with one series
constexpr double panel_gap = 46.0;
constexpr int most_ticks = 7;
constexpr int most_panel_ticks = 4;

/// One area of the chart with the series that it shows.
struct Panel {
  PlotArea area;
  std::size_t first_series = 0;
  std::size_t series = 0;
  std::string title;
};

std::vector<Panel> make_panels(const BarChart& chart) {
  const auto categories = static_cast<double>(chart.categories.size());
  const std::size_t series = chart.series.size();
  PlotArea area = {left, top, std::min(width, categories * widest_group), single_height};
  if (series == 1 || area.width / categories / static_cast<double>(series) >= narrowest_bar) {
    return {{area, 0, series, chart.y_label}};
  }
  std::vector<Panel> panels;
  area.height = panel_height;
  for (std::size_t i = 0; i < series; ++i) {
    panels.push_back({area, i, 1, fmt::format("{}: {}", chart.y_label, chart.series[i].name)});
    area.top = area.bottom() + panel_gap;
  }
  return panels;
}

/// Every second band is tinted, so that eyes keep to their column.
std::string draw_bands(const std::vector<BandStretch>& bands, const PlotArea& area) {
  std::string svg;
  for (std::size_t i = 0; i < bands.size(); i += 2) {
    svg += fmt::format("<path class=\"band\" d=\"M{} {}h{}v{}H{}z\"/>\n",
                       format_length(area.x(bands[i].start)), format_length(area.top),
                       format_length((bands[i].end - bands[i].start) * area.width),
                       format_length(area.height), format_length(area.x(bands[i].start)));
  }
  return svg;
}

/// The bars of one series of a panel.
std::string draw_bars(const BarChart& chart, std::size_t series, const Panel& panel,
                      const Axis& axis) {
  const BarSeries& bars = chart.series[series];
  const double slot = panel.area.width / static_cast<double>(chart.categories.size());
  const double gap = slot >= 6.0 ? 0.2 * slot : slot >= 2.0 ? 0.1 * slot : 0.0;
  const double bar = (slot - gap) / static_cast<double>(panel.series);
  const double base = panel.area.y(axis.position(0.0));
  std::string svg = fmt::format("<g class=\"bar {}\">\n", series_class(series));
  for (std::size_t i = 0; i < std::min(bars.values.size(), chart.categories.size()); ++i) {
    if (!std::isfinite(bars.values[i])) continue;
    const double end = panel.area.y(axis.position(bars.values[i]));
    const double x = panel.area.left + static_cast<double>(i) * slot + gap / 2.0 +
                     static_cast<double>(series - panel.first_series) * bar;
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"><title>{}, {}: {:.4g}</title></rect>\n",
        format_length(x), format_length(std::min(base, end)), format_length(bar),
        format_length(std::abs(end - base)), escape_markup(chart.categories[i]),
        escape_markup(bars.name), bars.values[i]);
  }
  return svg + "</g>\n";
}

std::string draw_panel(const BarChart& chart, const std::vector<BandStretch>& bands,
                       const Panel& panel, Range range) {
  const Axis axis =
      make_linear_axis(range.lowest, range.highest,
                       panel.area.height == panel_height ? most_panel_ticks : most_ticks);
  std::string svg = draw_bands(bands, panel.area) +
                    svg_text(0.0, panel.area.top - 16.0, Anchor::start, panel.title) +
                    svg_y_axis(panel.area, axis);
  for (std::size_t i = 0; i < panel.series; ++i) {
    svg += draw_bars(chart, panel.first_series + i, panel, axis);
  }
  return svg;
}

std::vector<StretchLabel> category_labels(const BarChart& chart, const PlotArea& area) {
  const std::size_t count = chart.categories.size();
  if (count > most_names) return {};
  const double slot = area.width / static_cast<double>(count);
  std::vector<StretchLabel> labels;
  for (std::size_t i = 0; i < count; ++i) {
    labels.push_back(
        {area.left + (static_cast<double>(i) + 0.5) * slot, slot, chart.categories[i]});
  }
  return labels;
}

}  // namespace

std::string svg_bar_chart(const BarChart& chart) {
  std::optional<Range> range;
  for (const BarSeries& series : chart.series) range = finite_range(series.values, range);
  if (!range || chart.categories.empty()) return "";
  range->lowest = std::min(range->lowest, 0.0);
  range->highest = std::max(range->highest, 0.0);
  const std::vector<BandStretch> bands = band_stretches(chart.bands, chart.categories.size());
  std::string content;
  PlotArea area;
  for (const Panel& panel : make_panels(chart)) {
    content += draw_panel(chart, bands, panel, *range);
    area = panel.area;
  }
  const std::vector<StretchLabel> labels =
      bands.empty() ? category_labels(chart, area) : band_labels(bands, area);
  const StretchLabels written = svg_stretch_labels(area.bottom(), labels);
  return svg_element(area.right() + 24.0, area.bottom() + written.height + 12.0, chart.caption,
                     content + written.svg);
}

}  // namespace mdbd
