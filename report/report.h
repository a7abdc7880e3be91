#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

/// A report as data: what is said, not how it looks. format_report_html() and format_report_text()
/// show it. All texts are plain; whoever shows them escapes what must be.
namespace mdbd {

/// Rows of texts below column titles. Columns of numbers are set to the right.
struct Table {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  bool is_summary = false;  ///< short, and shown on the terminal, too
};

struct LineSeries {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
};

/// Lines over common axes. Values that are not finite interrupt their line.
struct LineChart {
  std::string caption;
  std::string x_label;
  std::string y_label;
  std::vector<LineSeries> series;
  bool has_unit_range = false;  ///< both axes run from 0 to 1
  bool is_x_logarithmic = false;
};

struct BarSeries {
  std::string name;
  std::vector<double> values;  ///< one for each category
};

/// A band of neighbouring rows, columns or bars that belong together: a class.
struct Band {
  std::string name;
  std::size_t count = 0;
};

/// Bars, one of each series side by side for each category.
struct BarChart {
  std::string caption;
  std::string y_label;
  std::vector<std::string> categories;  ///< may be many; then only bands are labelled
  std::vector<Band> bands;              ///< of categories; may be empty
  std::vector<BarSeries> series;
};

/// A square matrix as a picture, dark where values are small, with a line between bands. The
/// colours run up to the 98th percentile, so that a few values far out do not hide the others.
struct MatrixPicture {
  std::string caption;
  std::size_t size = 0;
  std::vector<double> values;  ///< row after row
  std::vector<Band> bands;
};

/// Counts by true class (rows) and predicted class (columns), shaded.
struct ConfusionMatrix {
  std::string caption;
  std::vector<std::string> classes;
  std::vector<std::vector<std::size_t>> counts;
};

struct Paragraph {
  std::string text;
};

using Block = std::variant<Paragraph, Table, LineChart, BarChart, MatrixPicture, ConfusionMatrix>;

struct Section {
  std::string heading;
  std::vector<Block> blocks;
};

struct Report {
  std::string title;    ///< "Retrieval on lpsb"
  std::string summary;  ///< one or two sentences with the answer
  /// What produced it: command, recipe, seeds, version …
  std::vector<std::pair<std::string, std::string>> provenance;
  std::vector<std::string> notes;  ///< what limits its meaning: failed models, small classes …
  std::vector<Section> sections;
  /// The numbers, for programs: an object whose members have other names than those of the report
  /// itself (title, summary, provenance, notes).
  nlohmann::ordered_json data;
};

}  // namespace mdbd
