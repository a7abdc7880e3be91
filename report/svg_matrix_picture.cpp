#include "report/svg_matrix_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "cli/utf8.h"
#include "features/core/errors.h"
#include "picture/encode_png.h"
#include "report/axis.h"
#include "report/svg_frame.h"

namespace mdbd {
namespace {

constexpr double widest = 640.0;
constexpr double largest_cell = 24.0;
constexpr double smallest_side = 160.0;
constexpr double top = 12.0;
constexpr double label_distance = 12.0;
constexpr std::size_t longest_label = 18;
/// A few values far out must not take the contrast from all others.
constexpr double shown_share = 0.98;

constexpr std::size_t shades = 255;
constexpr std::uint8_t unknown = 255;  ///< the colour of what is no number

/// ColorBrewer's YlGnBu, darkest first (Harrower and Brewer 2003): ordered by lightness, so that it
/// survives grey printing, and safe for the colour-blind.
constexpr std::array<Rgb, 9> anchors = {{{8, 29, 88},
                                         {37, 52, 148},
                                         {34, 94, 168},
                                         {29, 145, 192},
                                         {65, 182, 196},
                                         {127, 205, 187},
                                         {199, 233, 180},
                                         {237, 248, 177},
                                         {255, 255, 217}}};

std::vector<Rgb> make_palette() {
  std::vector<Rgb> palette;
  for (std::size_t i = 0; i < shades; ++i) {
    const double place = static_cast<double>(i * (anchors.size() - 1)) / (shades - 1);
    const std::size_t anchor = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
    const double share = place - static_cast<double>(anchor);
    Rgb colour;
    for (std::size_t c = 0; c < 3; ++c) {
      const double mixed = (1.0 - share) * anchors[anchor][c] + share * anchors[anchor + 1][c];
      colour[c] = static_cast<std::uint8_t>(std::lround(mixed));
    }
    palette.push_back(colour);
  }
  palette.push_back({150, 150, 150});
  return palette;
}

struct ColourScale {
  Range range;
  bool is_cut = false;  ///< there are values above it
};

ColourScale make_scale(const std::vector<double>& values) {
  std::vector<double> finite;
  std::ranges::copy_if(values, std::back_inserter(finite),
                       [](double value) { return std::isfinite(value); });
  if (finite.empty()) return {};
  const Range whole = *finite_range(finite);
  const auto last = finite.begin() + static_cast<std::ptrdiff_t>(
                                         shown_share * static_cast<double>(finite.size() - 1));
  std::ranges::nth_element(finite, last);
  if (*last <= whole.lowest) return {whole, false};
  return {{whole.lowest, *last}, *last < whole.highest};
}

std::uint8_t shade_of(double value, const Range& range) {
  if (!std::isfinite(value)) return unknown;
  if (range.highest <= range.lowest) return 0;
  // Halves: the difference of two large numbers may have no room in a double.
  const double share =
      (value / 2.0 - range.lowest / 2.0) / (range.highest / 2.0 - range.lowest / 2.0);
  return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * (shades - 1)));
}

std::string draw_image(const PlotArea& area, std::span<const std::uint8_t> pixels,
                       std::size_t width, std::size_t height) {
  return fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "href=\"data:image/png;base64,{}\"/>\n",
      format_length(area.left), format_length(area.top), format_length(area.width),
      format_length(area.height), encode_base64(encode_png(pixels, width, height, make_palette())));
}

/// The width of the bands' names beside the matrix.
double label_room(const std::vector<BandStretch>& bands) {
  double room = 16.0;  // for the slanted name of the first band below the matrix
  for (const BandStretch& band : bands) {
    room = std::max(room, text_width(shorten(band.name, longest_label)) + 16.0);
  }
  return room;
}

std::string draw_bands(const std::vector<BandStretch>& bands, const PlotArea& area) {
  std::string svg;
  double free_from = area.top;
  for (const BandStretch& band : bands) {
    const double middle = area.top + (band.start + band.end) / 2.0 * area.height;
    if (middle >= free_from) {
      svg +=
          svg_text(area.left - 8.0, middle + 4.0, Anchor::end, shorten(band.name, longest_label));
      free_from = middle + label_distance;
    }
    if (band.start == 0.0) continue;
    svg += fmt::format(
        "<path class=\"boundary\" d=\"M{} {}V{}M{} {}H{}\"/>\n", format_length(area.x(band.start)),
        format_length(area.top), format_length(area.bottom()), format_length(area.left),
        format_length(area.top + band.start * area.height), format_length(area.right()));
  }
  return svg;
}

std::string draw_scale(const PlotArea& matrix, const ColourScale& scale) {
  const PlotArea area = {matrix.right() + 24.0, matrix.top, 14.0, std::min(matrix.height, 240.0)};
  std::vector<std::uint8_t> ramp(shades);
  for (std::size_t i = 0; i < shades; ++i) ramp[i] = static_cast<std::uint8_t>(shades - 1 - i);
  return draw_image(area, ramp, 1, shades) +
         svg_text(area.right() + 6.0, area.top + 10.0, Anchor::start,
                  fmt::format("{:.3g}{}", scale.range.highest, scale.is_cut ? " and more" : "")) +
         svg_text(area.right() + 6.0, area.bottom(), Anchor::start,
                  fmt::format("{:.3g}", scale.range.lowest));
}

}  // namespace

std::string svg_matrix_picture(const MatrixPicture& picture) {
  if (picture.size == 0) return "";
  if (picture.values.size() != picture.size * picture.size) {
    throw InvalidInput(fmt::format("a matrix of {} rows and columns cannot have {} values",
                                   picture.size, picture.values.size()));
  }
  const double side =
      std::clamp(static_cast<double>(picture.size) * largest_cell, smallest_side, widest);
  const ColourScale scale = make_scale(picture.values);
  std::vector<std::uint8_t> pixels;
  for (const double value : picture.values) pixels.push_back(shade_of(value, scale.range));
  const std::vector<BandStretch> bands = band_stretches(picture.bands, picture.size);
  const PlotArea area = {label_room(bands), top, side, side};
  const StretchLabels labels = svg_stretch_labels(area.bottom(), band_labels(bands, area));
  return svg_element(area.right() + 140.0, area.bottom() + labels.height + 12.0, picture.caption,
                     draw_image(area, pixels, picture.size, picture.size) +
                         draw_bands(bands, area) + draw_scale(area, scale) + labels.svg);
}

}  // namespace mdbd
