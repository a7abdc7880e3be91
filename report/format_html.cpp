#include <fmt/format.h>

#include "report/format_report.h"
#include "report/html_tables.h"
#include "report/markup.h"
#include "report/page_style.h"
#include "report/svg_bar_chart.h"
#include "report/svg_line_chart.h"
#include "report/svg_matrix_picture.h"
#include "report/svg_series.h"

namespace mdbd {
namespace {

constexpr std::string_view no_break_space = "\xC2\xA0";
constexpr std::size_t sections_without_contents = 2;

/// A running text, with every percent sign on the line of its number.
std::string running_text(std::string_view text) {
  std::string escaped = escape_markup(text);
  for (std::size_t at = escaped.find(" %"); at != std::string::npos; at = escaped.find(" %", at)) {
    escaped.replace(at, 1, no_break_space);
  }
  return escaped;
}

std::string figure(std::string_view caption, std::string_view legend, std::string_view svg) {
  constexpr std::string_view nothing = "<p class=\"nothing\">There are no values to show.</p>\n";
  return fmt::format("<figure>\n<figcaption>{}</figcaption>\n{}{}</figure>\n",
                     escape_markup(caption), svg.empty() ? "" : legend,
                     svg.empty() ? nothing : svg);
}

template <typename Series>
std::string legend_of(const std::vector<Series>& series, LegendKind kind) {
  std::vector<std::string> names;
  names.reserve(series.size());
  for (const Series& one : series) names.push_back(one.name);
  return html_legend(names, kind);
}

/// A block as HTML; one function for each kind.
struct BlockWriter {
  std::string operator()(const Paragraph& paragraph) const {
    return fmt::format("<p>{}</p>\n", running_text(paragraph.text));
  }
  std::string operator()(const Table& table) const { return html_table(table); }
  std::string operator()(const LineChart& chart) const {
    return figure(chart.caption, legend_of(chart.series, LegendKind::lines), svg_line_chart(chart));
  }
  std::string operator()(const BarChart& chart) const {
    return figure(chart.caption, legend_of(chart.series, LegendKind::bars), svg_bar_chart(chart));
  }
  std::string operator()(const MatrixPicture& picture) const {
    return figure(picture.caption, "", svg_matrix_picture(picture));
  }
  std::string operator()(const ConfusionMatrix& matrix) const {
    return html_confusion_matrix(matrix);
  }
};

std::string html_contents(const Report& report) {
  if (report.sections.size() <= sections_without_contents) return "";
  std::string html = "<nav aria-label=\"Contents\">\n<ul>\n";
  for (std::size_t i = 0; i < report.sections.size(); ++i) {
    html += fmt::format("<li><a href=\"#section-{}\">{}</a></li>\n", i + 1,
                        escape_markup(report.sections[i].heading));
  }
  return html + "</ul>\n</nav>\n";
}

std::string html_notes(const Report& report) {
  if (report.notes.empty()) return "";
  std::string html = "<aside class=\"notes\">\n<h2>To keep in mind</h2>\n<ul>\n";
  for (const std::string& note : report.notes) {
    html += fmt::format("<li>{}</li>\n", running_text(note));
  }
  return html + "</ul>\n</aside>\n";
}

std::string html_provenance(const Report& report) {
  if (report.provenance.empty()) return "";
  std::string html = "<section>\n<h2>How this report was made</h2>\n<dl>\n";
  for (const auto& [name, value] : report.provenance) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_markup(name), escape_markup(value));
  }
  return html + "</dl>\n</section>\n";
}

}  // namespace

std::string format_report_html(const Report& report) {
  std::string html = page_head(report.title) + "<body>\n<main>\n<header>\n";
  html += fmt::format(
      "<p class=\"maker\">MDBD shape search</p>\n<h1>{}</h1>\n<p class=\"summary\">{}</p>\n",
      escape_markup(report.title), running_text(report.summary));
  html += html_contents(report) + "</header>\n" + html_notes(report);
  for (std::size_t i = 0; i < report.sections.size(); ++i) {
    html += fmt::format("<section id=\"section-{}\">\n<h2>{}</h2>\n", i + 1,
                        escape_markup(report.sections[i].heading));
    for (const Block& block : report.sections[i].blocks) html += std::visit(BlockWriter{}, block);
    html += "</section>\n";
  }
  return html + html_provenance(report) + "</main>\n</body>\n</html>\n";
}

}  // namespace mdbd
