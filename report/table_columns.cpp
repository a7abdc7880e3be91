#include "report/table_columns.h"

#include <algorithm>
#include <array>

namespace mdbd {
namespace {

constexpr std::string_view digits = "0123456789";
constexpr std::string_view number_characters = "0123456789.,+-eE%/ ";
constexpr std::array<std::string_view, 4> number_signs = {"±", "×", "−", "∞"};

bool is_nothing(std::string_view cell) { return cell.empty() || cell == "–" || cell == "none"; }

}  // namespace

bool is_number(std::string_view cell) {
  const std::size_t first = cell.find_first_of("0123456789eE");
  if (first == std::string_view::npos || digits.find(cell[first]) == std::string_view::npos) {
    return false;
  }
  while (!cell.empty()) {
    const auto* sign = std::ranges::find_if(
        number_signs, [&](std::string_view candidate) { return cell.starts_with(candidate); });
    if (sign != number_signs.end()) {
      cell.remove_prefix(sign->size());
    } else if (number_characters.find(cell.front()) != std::string_view::npos) {
      cell.remove_prefix(1);
    } else {
      return false;
    }
  }
  return true;
}

bool is_number_column(const Table& table, std::size_t column) {
  bool has_number = false;
  for (const auto& row : table.rows) {
    if (column >= row.size() || is_nothing(row[column])) continue;
    if (!is_number(row[column])) return false;
    has_number = true;
  }
  return has_number;
}

}  // namespace mdbd
