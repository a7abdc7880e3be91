// Tables of points: what XYZ, TXT and CSV files have in common, whatever separates the numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "features/core/errors.h"
#include "features/shape_io/point_formats.h"
#include "features/shape_io/read_point_cloud.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

constexpr std::size_t most_columns = 1000;
constexpr std::size_t no_column = most_columns;

using Words = std::vector<std::string_view>;

/// Where the numbers of a point stand in a line.
struct Columns {
  std::array<std::size_t, 3> point = {0, 1, 2};
  std::array<std::size_t, 3> normal = {no_column, no_column, no_column};

  bool has_normal() const { return std::ranges::count(normal, no_column) == 0; }
  std::size_t count() const {
    std::size_t last = std::ranges::max(point);
    if (has_normal()) last = std::max(last, std::ranges::max(normal));
    return last + 1;
  }
};

std::string_view strip(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\v\f\"";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

bool is_comment(std::string_view line) { return line.starts_with('#') || line.starts_with("//"); }

// A comma or a semicolon separates if there is one, even from an empty word; else blanks do.
void split(std::string_view line, Words& words) {
  words.clear();
  const bool has_semicolon = line.find(';') != line.npos;
  const bool has_comma = line.find(',') != line.npos;
  const std::string_view separators = has_semicolon ? ";" : has_comma ? "," : " \t\v\f";
  while (!line.empty() && words.size() < most_columns) {
    const std::size_t end = std::min(line.find_first_of(separators), line.size());
    words.push_back(strip(line.substr(0, end)));
    line.remove_prefix(std::min(end + 1, line.size()));
    if (!has_semicolon && !has_comma) line = strip(line);
  }
}

/// Walks over the lines that are neither blank nor comments.
class Lines {
 public:
  explicit Lines(std::string_view text)
      : text_(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text) {}

  bool next(Words& words) {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find_first_of("\n\r"), text_.size());
      const std::string_view line = strip(text_.substr(0, end));
      const bool is_pair = text_.substr(end).starts_with("\r\n");
      text_.remove_prefix(std::min(end + (is_pair ? 2 : 1), text_.size()));
      ++number_;
      if (line.empty() || is_comment(line)) continue;
      split(line, words);
      return true;
    }
    return false;
  }

  bool is_last() const { return text_.empty(); }
  std::size_t number() const { return number_; }  ///< of the line that was read, from 1

 private:
  std::string_view text_;
  std::size_t number_ = 0;
};

bool are_numbers(const Words& words, std::size_t count) {
  return words.size() >= count &&
         std::all_of(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count),
                     [](std::string_view word) { return parse_number(word).has_value(); });
}

std::size_t find_name(const Words& names, std::initializer_list<std::string_view> known) {
  for (const std::string_view name : known) {
    const auto found = std::ranges::find_if(
        names, [&](std::string_view word) { return equals_ignoring_case(word, name); });
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  }
  return no_column;
}

/// The columns as a header names them; nothing if it does not name x, y and z.
std::optional<Columns> columns_by_name(const Words& names) {
  Columns columns;
  columns.point = {find_name(names, {"x", "//x", "#x"}), find_name(names, {"y"}),
                   find_name(names, {"z"})};
  columns.normal = {find_name(names, {"nx", "normal_x", "normalx"}),
                    find_name(names, {"ny", "normal_y", "normaly"}),
                    find_name(names, {"nz", "normal_z", "normalz"})};
  if (std::ranges::count(columns.point, no_column) > 0) return std::nullopt;
  return columns;
}

/// A table without a header whose lines have six numbers or more may have normals.
Columns columns_by_place(const Words& first) {
  Columns columns;
  if (are_numbers(first, 6)) columns.normal = {3, 4, 5};
  return columns;
}

bool is_header(const Words& words) {
  return !words.empty() && !words.front().empty() && !parse_number(words.front());
}

Eigen::Vector3d read_numbers(const Words& words, const std::array<std::size_t, 3>& columns,
                             std::size_t line) {
  Eigen::Vector3d numbers;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = words[columns[axis]];
    const auto number = parse_number(word);
    if (!number) {
      throw InvalidInput("line " + std::to_string(line) + ": '" + std::string(word.substr(0, 40)) +
                         "' is no number");
    }
    numbers[axis] = *number;
  }
  return numbers;
}

bool are_unit_vectors(const std::vector<Eigen::Vector3d>& vectors) {
  constexpr double tolerance = 0.02;
  return std::ranges::all_of(vectors, [](const Eigen::Vector3d& vector) {
    return std::abs(vector.norm() - 1.0) <= tolerance;
  });
}

void append(const Words& words, const Columns& columns, const Lines& lines, PointCloud& cloud) {
  if (words.size() < columns.count()) {
    throw InvalidInput("line " + std::to_string(lines.number()) + " has " +
                       std::to_string(words.size()) + " columns, at least " +
                       std::to_string(columns.count()) + " are needed" +
                       (lines.is_last() ? "; the file may be truncated" : ""));
  }
  cloud.points.push_back(read_numbers(words, columns.point, lines.number()));
  if (columns.has_normal()) {
    cloud.normals.push_back(read_numbers(words, columns.normal, lines.number()));
  }
}

}  // namespace

PointCloud read_point_table(std::string_view bytes) {
  if (bytes.find('\0') != bytes.npos) throw InvalidInput("not a text of points: it has zero bytes");
  Lines lines(bytes);
  Words words;
  if (!lines.next(words)) throw InvalidInput("the file has no points");
  PointCloud cloud;
  std::optional<Columns> columns;
  if (is_header(words)) {
    columns = columns_by_name(words);
    if (!columns) {
      throw InvalidInput("not a table of points: line " + std::to_string(lines.number()) +
                         " has neither numbers nor the names x, y and z");
    }
    if (!lines.next(words)) throw InvalidInput("the file has no points");
  } else if (words.size() == 1 && parse_integer(words.front())) {
    // Some XYZ files begin with the number of points.
    if (!lines.next(words)) throw InvalidInput("the file has no points");
  }
  const bool has_names = columns.has_value();
  if (!has_names) columns = columns_by_place(words);
  do {
    append(words, *columns, lines, cloud);
  } while (lines.next(words));
  if (!has_names && !are_unit_vectors(cloud.normals)) cloud.normals.clear();
  return cloud;
}

bool looks_like_points(std::string_view beginning) {
  constexpr int lines_needed = 3;
  if (beginning.find('\0') != beginning.npos) return false;
  Lines lines(beginning);
  Words words;
  if (!lines.next(words)) return false;
  if (is_header(words)) {
    const auto columns = columns_by_name(words);
    return columns.has_value() && lines.next(words) && words.size() >= columns->count();
  }
  if (words.size() == 1 && parse_integer(words.front())) lines.next(words);
  for (int line = 0; line < lines_needed; ++line) {
    if (!are_numbers(words, 3) || words.size() > 12) return false;
    if (!lines.next(words) || lines.is_last()) break;
  }
  return true;
}

}  // namespace mdbd
