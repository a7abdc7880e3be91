#include <algorithm>
#include <limits>
#include <string>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "report/svg_bar_chart.h"
#include "report/svg_frame.h"
#include "report/svg_line_chart.h"
#include "report/svg_matrix_picture.h"
#include "report/svg_series.h"

using namespace mdbd;
using Catch::Matchers::Contains;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

BarChart bars_of(std::size_t categories, std::size_t series) {
  BarChart chart{"caption", "distance", {}, {}, {}};
  for (std::size_t i = 0; i < categories; ++i) chart.categories.push_back(std::to_string(i));
  for (std::size_t i = 0; i < series; ++i) {
    chart.series.push_back({"series", std::vector<double>(categories, 1.0)});
  }
  return chart;
}

}  // namespace

TEST_CASE("a line chart draws its points where they belong") {
  const LineChart chart{"caption", "recall", "precision", {{"a", {0, 1}, {1, 0}}}, true};
  const std::string svg = svg_line_chart(chart);
  CHECK_THAT(svg, Contains("d=\"M64 30h0L504 470\""));
  CHECK_THAT(svg, Contains("aria-label=\"caption\""));
  CHECK_THAT(svg, Contains(">recall</text>"));
  CHECK_THAT(svg, Contains(">precision</text>"));
}

TEST_CASE("what is not finite interrupts a line") {
  const LineChart gap{"", "", "", {{"a", {0, 1, 2, 3, 4}, {1, 1, nan_value, 1, 1}}}};
  CHECK(count(svg_line_chart(gap), "h0") == 2);
  CHECK(count(svg_line_chart(gap), "<circle") == 4);
  const LineChart logarithmic{"", "", "", {{"a", {0, 1, 10}, {1, 2, 3}}}, false, true};
  CHECK(count(svg_line_chart(logarithmic), "<circle") == 2);
}

TEST_CASE("charts without values are empty") {
  CHECK(svg_line_chart({}).empty());
  CHECK(svg_line_chart({"", "", "", {{"a", {1}, {}}, {"b", {nan_value}, {1}}}}).empty());
  CHECK(svg_bar_chart({}).empty());
  CHECK(svg_bar_chart({"", "", {"a"}, {}, {{"b", {nan_value}}}}).empty());
  CHECK(svg_matrix_picture({}).empty());
}

TEST_CASE("every value has a bar") {
  for (const std::size_t categories : {1, 2, 40, 1000}) {
    for (const std::size_t series : {1, 3}) {
      INFO(categories << " categories, " << series << " series");
      CHECK(count(svg_bar_chart(bars_of(categories, series)), "<rect") == categories * series);
    }
  }
  BarChart gap = bars_of(3, 1);
  gap.series[0].values[1] = nan_value;
  CHECK(count(svg_bar_chart(gap), "<rect") == 2);
}

TEST_CASE("negative bars hang from zero") {
  BarChart chart = bars_of(2, 1);
  chart.series[0].values = {1.0, -1.0};
  const std::string svg = svg_bar_chart(chart);
  CHECK_THAT(svg, Contains("y=\"30\"") && Contains("y=\"180\"") && Contains("height=\"150\""));
}

TEST_CASE("narrow bars get a panel for each series") {
  CHECK(count(svg_bar_chart(bars_of(40, 2)), "distance: series") == 0);
  CHECK(count(svg_bar_chart(bars_of(1000, 2)), "distance: series") == 2);
}

TEST_CASE("bands are labelled where they are, and only inside") {
  const std::vector<Band> bands = {{"a", 2}, {"empty", 0}, {"b", 5}, {"beyond", 1}};
  const std::vector<BandStretch> stretches = band_stretches(bands, 4);
  REQUIRE(stretches.size() == 2);
  CHECK(stretches[0].name == "a");
  CHECK(stretches[0].end == 0.5);
  CHECK(stretches[1].name == "b");
  CHECK(stretches[1].start == 0.5);
  CHECK(stretches[1].end == 1.0);
}

TEST_CASE("labels that would touch are left out") {
  std::vector<StretchLabel> labels(100, {0.0, 1.0, "label"});
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i].middle = static_cast<double>(i);
  CHECK(count(svg_stretch_labels(0.0, labels).svg, "<text") == 7);
  CHECK(svg_stretch_labels(0.0, {}).height == 0.0);
}

TEST_CASE("a matrix picture says where its colours end") {
  MatrixPicture picture{"caption", 20, std::vector<double>(400, 0.5), {{"a", 10}, {"b", 10}}};
  picture.values[0] = 0.0;
  picture.values[1] = 100.0;
  const std::string svg = svg_matrix_picture(picture);
  CHECK_THAT(svg, Contains(">0.5 and more</text>"));
  CHECK(count(svg, "class=\"boundary\"") == 1);
  CHECK(count(svg, "data:image/png;base64,") == 2);
  picture.values.pop_back();
  CHECK_THROWS_AS(svg_matrix_picture(picture), InvalidInput);
}

TEST_CASE("forty series look different, and one needs no legend") {
  std::vector<std::string> seen;
  for (std::size_t i = 0; i < 40; ++i) {
    CHECK(std::find(seen.begin(), seen.end(), series_class(i)) == seen.end());
    seen.push_back(series_class(i));
  }
  const std::vector<std::string> names = {"clean", "<noisy>"};
  CHECK(html_legend({names.data(), 1}, LegendKind::bars).empty());
  CHECK_THAT(html_legend(names, LegendKind::lines), Contains("<span>&lt;noisy&gt;</span>"));
}
