#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/axis.h"
#include "report/report.h"

/// What the pictures of a report share: frames, axes, labels. Lengths are CSS pixels, y downwards.
/// How elements of a class look is said by the page's style sheet.
namespace mdbd {

/// A rectangle of a picture in which values are drawn.
struct PlotArea {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
  double x(double fraction) const { return left + fraction * width; }
  double y(double fraction) const { return bottom() - fraction * height; }
};

/// Which way a text runs from its point.
enum class Anchor { start, middle, end };

/// A length with as many digits as a picture needs.
std::string format_length(double length);

/// An svg element with everything in it.
/// @param label tells those who do not see the picture what it is
std::string svg_element(double width, double height, std::string_view label,
                        std::string_view content);

/// About how wide a text will be.
double text_width(std::string_view text);

std::string svg_text(double x, double y, Anchor anchor, std::string_view text);

/// The smallest and the largest of the finite values; nothing if there are none.
struct Range {
  double lowest = 0.0;
  double highest = 0.0;
};
std::optional<Range> finite_range(std::span<const double> values, std::optional<Range> so_far = {});

/// Lines across the area at the ticks, with the ticks' values to the left of it.
std::string svg_y_axis(const PlotArea& area, const Axis& axis);

/// Ticks with their values below the area, and below those the axis' label.
std::string svg_x_axis(const PlotArea& area, const Axis& axis, std::string_view label);

/// A label of a stretch below an area.
struct StretchLabel {
  double middle = 0.0;  ///< its x
  double width = 0.0;   ///< of the stretch
  std::string text;
};

/// Labels below an area, and the height that they take. They are slanted if one is wider than its
/// stretch, and left out where they would touch.
struct StretchLabels {
  std::string svg;
  double height = 0.0;
};
StretchLabels svg_stretch_labels(double top, std::span<const StretchLabel> labels);

/// The stretch of each band along a side of an area.
struct BandStretch {
  std::string name;
  double start = 0.0;  ///< as a fraction of the side
  double end = 0.0;
};

/// @param count of all things on the side; what lies beyond it is left out
std::vector<BandStretch> band_stretches(std::span<const Band> bands, std::size_t count);

/// The names of bands, to be written below an area.
std::vector<StretchLabel> band_labels(std::span<const BandStretch> stretches, const PlotArea& area);

}  // namespace mdbd
