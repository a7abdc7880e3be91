#include "report/svg_line_chart.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "report/axis.h"
#include "report/svg_frame.h"
#include "report/svg_series.h"

namespace mdbd {
namespace {

constexpr PlotArea wide_area = {.left = 64.0, .top = 30.0, .width = 740.0, .height = 340.0};
constexpr PlotArea square_area = {.left = 64.0, .top = 30.0, .width = 440.0, .height = 440.0};
constexpr int most_x_ticks = 9;
constexpr int most_y_ticks = 7;
constexpr std::size_t most_markers = 12;  ///< of a line; more would hide its dashes

struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// The points of a series; nothing where the line is interrupted.
std::vector<std::optional<Point>> points_of(const LineSeries& series, const LineChart& chart) {
  std::vector<std::optional<Point>> points(std::min(series.x.size(), series.y.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = series.x[i];
    const bool is_shown =
        std::isfinite(x) && std::isfinite(series.y[i]) && (x > 0.0 || !chart.is_x_logarithmic);
    if (is_shown) points[i] = Point{x, series.y[i]};
  }
  return points;
}

struct Scales {
  Axis x;
  Axis y;
};

Scales make_scales(const LineChart& chart, Range x, Range y) {
  if (chart.has_unit_range) x = y = {0.0, 1.0};
  // An axis that nearly reaches zero should reach it.
  if (y.lowest > 0.0 && y.lowest < 0.5 * y.highest) y.lowest = 0.0;
  return {chart.is_x_logarithmic ? make_logarithmic_axis(x.lowest, x.highest, most_x_ticks)
                                 : make_linear_axis(x.lowest, x.highest, most_x_ticks),
          make_linear_axis(y.lowest, y.highest, most_y_ticks)};
}

std::string draw_series(const std::vector<std::optional<Point>>& points, std::size_t number,
                        const PlotArea& area, const Scales& scales) {
  std::string path;
  std::string markers;
  bool is_pen_down = false;
  for (const std::optional<Point>& point : points) {
    if (point) {
      const std::string x = format_length(area.x(scales.x.position(point->x)));
      const std::string y = format_length(area.y(scales.y.position(point->y)));
      // A point between two gaps is a line of no length; its round ends show it.
      path += is_pen_down ? fmt::format("L{} {}", x, y) : fmt::format("M{} {}h0", x, y);
      markers += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"3\"/>", x, y);
    }
    is_pen_down = point.has_value();
  }
  if (points.size() > most_markers) markers.clear();
  return fmt::format("<g class=\"{}\"><path class=\"line\" d=\"{}\"/>{}</g>\n",
                     series_class(number), path, markers);
}

}  // namespace

std::string svg_line_chart(const LineChart& chart) {
  std::vector<std::vector<std::optional<Point>>> lines;
  std::optional<Range> x;
  std::optional<Range> y;
  for (const LineSeries& series : chart.series) {
    lines.push_back(points_of(series, chart));
    for (const std::optional<Point>& point : lines.back()) {
      if (!point) continue;
      x = finite_range({&point->x, 1}, x);
      y = finite_range({&point->y, 1}, y);
    }
  }
  if (!x) return "";
  const PlotArea area = chart.has_unit_range ? square_area : wide_area;
  const Scales scales = make_scales(chart, *x, *y);
  std::string content = svg_text(0.0, 14.0, Anchor::start, chart.y_label) +
                        svg_y_axis(area, scales.y) + svg_x_axis(area, scales.x, chart.x_label);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    content += draw_series(lines[i], i, area, scales);
  }
  return svg_element(area.right() + 24.0, area.bottom() + 52.0, chart.caption, content);
}

}  // namespace mdbd
