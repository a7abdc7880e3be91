#include <algorithm>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "cli/terminal.h"
#include "cli/utf8.h"
#include "report/format_report.h"
#include "report/table_columns.h"

namespace mdbd {
namespace {

constexpr int narrowest_terminal = 20;
constexpr std::size_t column_gap = 2;
constexpr std::size_t narrowest_column = 8;  ///< unless its texts are shorter

/// The end of the word that begins at a position. A percent sign stays with its number.
std::size_t word_end(std::string_view text, std::size_t start) {
  std::size_t end = text.find(' ', start);
  while (end != std::string_view::npos && text.substr(end + 1).starts_with('%')) {
    end = text.find(' ', end + 1);
  }
  return std::min(end, text.size());
}

/// A text in lines of at most so many columns, broken at blanks.
std::vector<std::string> wrap(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = word_end(text, start);
    const std::string_view word = text.substr(start, end - start);
    if (!lines.empty() && display_width(lines.back()) + 1 + display_width(word) <= width) {
      lines.back() += ' ';
      lines.back() += word;
    } else {
      lines.emplace_back(word);
    }
    start = end + 1;
  }
  return lines;
}

/// @param mark stands before the first line; the others are indented by its length
std::string paragraph(std::string_view text, std::size_t width, std::string_view mark = "") {
  std::string shown;
  for (const std::string& line : wrap(printable_message(text), width - mark.size())) {
    shown += shown.empty() ? std::string(mark) : std::string(mark.size(), ' ');
    shown += line + "\n";
  }
  return shown;
}

std::string cell_of(const std::vector<std::string>& row, std::size_t column) {
  return column < row.size() ? printable_message(row[column]) : "";
}

std::size_t longest_word(std::string_view text) {
  std::size_t longest = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = word_end(text, start);
    longest = std::max(longest, display_width(text.substr(start, end - start)));
    start = end + 1;
  }
  return longest;
}

std::size_t table_width(const std::vector<std::size_t>& widths) {
  const std::size_t gaps = widths.empty() ? 0 : (widths.size() - 1) * column_gap;
  return std::accumulate(widths.begin(), widths.end(), gaps);
}

/// The widths of columns that hold every cell whole.
/// @param breaks_titles the titles may be broken at blanks
std::vector<std::size_t> whole_widths(const Table& table, bool breaks_titles) {
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const std::string title = cell_of(table.columns, column);
    std::size_t widest = breaks_titles ? longest_word(title) : display_width(title);
    for (const auto& row : table.rows) {
      widest = std::max(widest, display_width(cell_of(row, column)));
    }
    widths.push_back(widest);
  }
  return widths;
}

/// The widths of a table's columns. Where they are too many for the terminal, titles are broken,
/// then the widest columns of texts.
std::vector<std::size_t> column_widths(const Table& table, std::size_t width) {
  std::vector<std::size_t> widths = whole_widths(table, false);
  if (table_width(widths) > width) widths = whole_widths(table, true);
  while (table_width(widths) > width) {
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

/// One line of a table.
std::string format_line(const Table& table, const std::vector<std::string>& cells,
                        const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t column = 0; column < widths.size(); ++column) {
    const std::size_t width = std::max<std::size_t>(widths[column], 1);
    const std::string cell = shorten(cells[column], width);
    if (column > 0) line.append(column_gap, ' ');
    line += is_number_column(table, column) ? fmt::format("{:>{}}", cell, width)
                                            : fmt::format("{:<{}}", cell, width);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

enum class Edge { top, bottom };

/// The cells of a row, broken to the widths of their columns.
/// @param edge where cells of fewer lines than others stand
std::string format_row(const Table& table, const std::vector<std::string>& row,
                       const std::vector<std::size_t>& widths, Edge edge) {
  std::vector<std::vector<std::string>> broken;
  std::size_t height = 1;
  for (std::size_t column = 0; column < widths.size(); ++column) {
    broken.push_back(wrap(cell_of(row, column), widths[column]));
    height = std::max(height, broken.back().size());
  }
  std::string text;
  for (std::size_t line = 0; line < height; ++line) {
    std::vector<std::string> cells;
    for (const auto& lines : broken) {
      const std::size_t first = edge == Edge::top ? 0 : height - lines.size();
      const bool is_filled = line >= first && line - first < lines.size();
      cells.push_back(is_filled ? lines[line - first] : "");
    }
    text += format_line(table, cells, widths);
  }
  return text;
}

std::string format_table(const Table& table, std::size_t width) {
  const std::vector<std::size_t> widths = column_widths(table, width);
  std::string text =
      paragraph(table.caption, width) + format_row(table, table.columns, widths, Edge::bottom);
  for (const auto& row : table.rows) text += format_row(table, row, widths, Edge::top);
  return text;
}

}  // namespace

std::string format_report_text(const Report& report, int columns) {
  const auto width = static_cast<std::size_t>(std::max(columns, narrowest_terminal));
  std::string text = paragraph(report.title, width) + paragraph(report.summary, width);
  for (const Section& section : report.sections) {
    for (const Block& block : section.blocks) {
      const Table* table = std::get_if<Table>(&block);
      if (table != nullptr && table->is_summary) text += "\n" + format_table(*table, width);
    }
  }
  if (!report.notes.empty()) text += "\n";
  for (const std::string& note : report.notes) text += paragraph(note, width, "Note: ");
  return text;
}

}  // namespace mdbd
