#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "cli/terminal.h"
#include "cli/utf8.h"
#include "evaluation/report/format_report.h"
#include "evaluation/report/table_columns.h"

namespace mdbd {
namespace {

constexpr std::size_t column_gap = 2;
constexpr std::size_t narrowest_column = 8;  ///< unless its texts are shorter

/// A text in lines of at most so many columns, broken at blanks; later lines are indented.
std::string wrap(std::string_view text, std::size_t width, std::size_t indent) {
  std::string wrapped;
  std::size_t used = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string_view word = text.substr(start, end - start);
    const std::size_t length = display_width(word);
    if (used > indent && used + 1 + length > width) {
      wrapped += "\n" + std::string(indent, ' ');
      used = indent;
    } else if (!wrapped.empty()) {
      wrapped += ' ';
      ++used;
    }
    wrapped += word;
    used += length;
    start = end + 1;
  }
  return wrapped + "\n";
}

std::string cell_of(const std::vector<std::string>& row, std::size_t column) {
  return column < row.size() ? printable_message(row[column]) : "";
}

/// The widths of a table's columns. Where they are too many for the terminal, the widest columns of
/// texts give way.
std::vector<std::size_t> column_widths(const Table& table, std::size_t width) {
  std::vector<std::size_t> widths;
  std::size_t total = 0;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    std::size_t widest = display_width(cell_of(table.columns, column));
    for (const auto& row : table.rows) {
      widest = std::max(widest, display_width(cell_of(row, column)));
    }
    widths.push_back(widest);
    total += widest + (column > 0 ? column_gap : 0);
  }
  for (; total > width; --total) {
    std::size_t* widest = nullptr;
    for (std::size_t column = 0; column < widths.size(); ++column) {
      if (is_number_column(table, column)) continue;
      if (widest == nullptr || widths[column] > *widest) widest = &widths[column];
    }
    if (widest == nullptr || *widest <= narrowest_column) break;
    --*widest;
  }
  return widths;
}

std::string format_row(const Table& table, const std::vector<std::string>& row,
                       const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t column = 0; column < widths.size(); ++column) {
    const std::string cell =
        shorten(cell_of(row, column), std::max<std::size_t>(widths[column], 1));
    if (column > 0) line.append(column_gap, ' ');
    line += is_number_column(table, column) ? fmt::format("{:>{}}", cell, widths[column])
                                            : fmt::format("{:<{}}", cell, widths[column]);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string format_table(const Table& table, std::size_t width) {
  const std::vector<std::size_t> widths = column_widths(table, width);
  std::string text = wrap(printable_message(table.caption), width, 0);
  text += format_row(table, table.columns, widths);
  for (const auto& row : table.rows) text += format_row(table, row, widths);
  return text;
}

}  // namespace

std::string format_report_text(const Report& report, int columns) {
  const auto width = static_cast<std::size_t>(std::max(columns, 20));
  std::string text = wrap(printable_message(report.title), width, 0) +
                     wrap(printable_message(report.summary), width, 0);
  for (const Section& section : report.sections) {
    for (const Block& block : section.blocks) {
      const Table* table = std::get_if<Table>(&block);
      if (table != nullptr && table->is_summary) text += "\n" + format_table(*table, width);
    }
  }
  if (!report.notes.empty()) text += "\n";
  for (const std::string& note : report.notes) {
    text += wrap("Note: " + printable_message(note), width, 6);
  }
  return text;
}

}  // namespace mdbd
