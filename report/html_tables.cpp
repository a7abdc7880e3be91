#include "report/html_tables.h"

#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "features/core/errors.h"
#include "report/markup.h"
#include "report/table_columns.h"

namespace mdbd {
namespace {

constexpr std::size_t most_wide_classes = 8;  ///< more columns have to be slim

std::string percentage(std::size_t part, std::size_t whole, int digits) {
  if (whole == 0) return "–";
  return fmt::format("{:.{}f}", 100.0 * static_cast<double>(part) / static_cast<double>(whole),
                     digits);
}

/// The table in a frame of its own that scrolls where the page is too narrow.
std::string framed(std::string_view table_class, std::string_view caption,
                   std::string_view content) {
  return fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"{0}\">\n"
      "<table class=\"{1}\">\n<caption>{0}</caption>\n{2}</table>\n</div>\n",
      escape_markup(caption), table_class, content);
}

void require_square(const ConfusionMatrix& matrix) {
  bool is_square = matrix.counts.size() == matrix.classes.size();
  for (const auto& row : matrix.counts) is_square &= row.size() == matrix.classes.size();
  if (!is_square) throw InvalidInput("a confusion matrix needs a row and a column for each class");
}

struct ConfusionSums {
  std::vector<std::size_t> rows;
  std::vector<std::size_t> columns;
  std::size_t diagonal = 0;
  std::size_t all = 0;
};

ConfusionSums sum_up(const ConfusionMatrix& matrix) {
  const std::size_t classes = matrix.classes.size();
  ConfusionSums sums = {std::vector<std::size_t>(classes), std::vector<std::size_t>(classes)};
  for (std::size_t row = 0; row < classes; ++row) {
    for (std::size_t column = 0; column < classes; ++column) {
      const std::size_t count = matrix.counts[row][column];
      sums.rows[row] += count;
      sums.columns[column] += count;
      sums.all += count;
      if (row == column) sums.diagonal += count;
    }
  }
  return sums;
}

std::string confusion_cell(std::size_t count, std::size_t row_sum, bool is_right) {
  if (count == 0) return "<td class=\"none\">0</td>";
  const double share = static_cast<double>(count) / static_cast<double>(row_sum);
  return fmt::format("<td class=\"{}{}\" style=\"--share:{:.3f}\">{}</td>",
                     is_right ? "right" : "wrong", share > 0.55 ? " strong" : "", share, count);
}

std::string confusion_head(const ConfusionMatrix& matrix) {
  std::string html = "<thead><tr><th scope=\"col\" class=\"corner\">true ↓ predicted →</th>";
  for (const std::string& name : matrix.classes) {
    html += fmt::format("<th scope=\"col\" class=\"upright\"><span>{}</span></th>",
                        escape_markup(name));
  }
  return html +
         "<th scope=\"col\" class=\"number\">models</th>"
         "<th scope=\"col\" class=\"number\">recall, %</th></tr></thead>\n";
}

}  // namespace

std::string html_table(const Table& table) {
  std::vector<std::string_view> classes;
  std::string html = "<thead><tr>";
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    classes.push_back(is_number_column(table, column) ? " class=\"number\"" : "");
    html += fmt::format("<th scope=\"col\"{}>{}</th>", classes.back(),
                        escape_markup(table.columns[column]));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      html += fmt::format("<td{}>{}</td>", classes[column],
                          column < row.size() ? escape_markup(row[column]) : "");
    }
    html += "</tr>\n";
  }
  return framed("data", table.caption, html + "</tbody>\n");
}

std::string html_confusion_matrix(const ConfusionMatrix& matrix) {
  require_square(matrix);
  const ConfusionSums sums = sum_up(matrix);
  const bool is_slim = matrix.classes.size() > most_wide_classes;
  std::string html = confusion_head(matrix) + "<tbody>\n";
  for (std::size_t row = 0; row < matrix.classes.size(); ++row) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", escape_markup(matrix.classes[row]));
    for (std::size_t column = 0; column < matrix.classes.size(); ++column) {
      html += confusion_cell(matrix.counts[row][column], sums.rows[row], row == column);
    }
    html += fmt::format("<td class=\"sum\">{}</td><td class=\"sum\">{}</td></tr>\n", sums.rows[row],
                        percentage(matrix.counts[row][row], sums.rows[row], 1));
  }
  html += "</tbody>\n<tfoot><tr><th scope=\"row\">precision, %</th>";
  for (std::size_t column = 0; column < matrix.classes.size(); ++column) {
    html += fmt::format(
        "<td class=\"sum\">{}</td>",
        percentage(matrix.counts[column][column], sums.columns[column], is_slim ? 0 : 1));
  }
  html += fmt::format(
      "<td class=\"sum\">{}</td><td class=\"sum\"><strong>{}</strong></td></tr></tfoot>\n",
      sums.all, percentage(sums.diagonal, sums.all, 1));
  return framed(is_slim ? "confusion slim" : "confusion", matrix.caption, html);
}

}  // namespace mdbd
