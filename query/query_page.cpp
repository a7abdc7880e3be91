#include "query/query_page.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "cli/terminal.h"
#include "picture/encode_png.h"
#include "picture/thumbnail.h"
#include "query/ball_viewer.h"
#include "query/explanation.h"
#include "query/query_page_style.h"
#include "report/html_tables.h"
#include "report/markup.h"
#include "report/page_style.h"
#include "report/svg_line_chart.h"
#include "report/svg_series.h"

namespace mdbd {
namespace {

constexpr std::size_t highlighted_balls = 8;
constexpr std::size_t sections_without_contents = 2;

std::string shown(std::string_view text) { return escape_markup(printable(text)); }

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string folder_of(const std::string& path) {
  return std::filesystem::path(path).parent_path().string();
}

std::string image(const ShapeData& data, const std::string& alternative) {
  const std::string png = data.thumbnail.empty() ? draw_balls(data.balls) : data.thumbnail;
  if (png.empty()) return "<span class=\"soft\">no picture</span>";
  return fmt::format(
      "<img src=\"data:image/png;base64,{}\" alt=\"{}\" width=\"{}\" height=\"{}\"/>",
      encode_base64(png), alternative, thumbnail_size, thumbnail_size);
}

std::string join(const std::vector<BallDifference>& balls) {
  std::string numbers;
  for (const BallDifference& ball : balls) {
    fmt::format_to(std::back_inserter(numbers), "{}{}", numbers.empty() ? "" : " ", ball.place + 1);
  }
  return numbers;
}

/// The page while it is written.
class QueryPage {
 public:
  QueryPage(std::span<const QueryAnswer> answers, const QueryPageOptions& options)
      : answers_(answers), options_(options) {}

  std::string format() {
    const std::string title = is_single()
                                  ? "Models like " + printable(file_name(answers_.front().query))
                                  : fmt::format("Matches of {} queries", answers_.size());
    std::string html = page_head(title, query_page_style());
    html += fmt::format(
        "<body>\n<main class=\"query\">\n<header>\n<p class=\"maker\">MDBD shape search</p>\n"
        "<h1>{}</h1>\n<p class=\"summary\">{}</p>\n{}</header>\n",
        escape_markup(title), summary(), contents());
    for (std::size_t i = 0; i < answers_.size(); ++i) html += section(i);
    return html + "</main>\n" + balls() + std::string(ball_viewer()) + "</body>\n</html>\n";
  }

 private:
  bool is_single() const { return answers_.size() == 1; }

  std::string summary() const {
    const std::size_t compared = answers_.empty() ? 0 : answers_.front().result.compared;
    return fmt::format(
        "Compared by {} with {} model{}; no model that is not shown is nearer. Click a picture to "
        "see its balls.",
        options_.signature, compared, compared == 1 ? "" : "s");
  }

  std::string contents() const {
    if (answers_.size() <= sections_without_contents) return "";
    std::string html = "<nav aria-label=\"Contents\">\n<ul>\n";
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      html += fmt::format("<li><a href=\"#query-{}\">{}</a></li>\n", i + 1,
                          shown(file_name(answers_[i].query)));
    }
    return html + "</ul>\n</nav>\n";
  }

  std::string section(std::size_t index) {
    const QueryAnswer& answer = answers_[index];
    const std::string name = fmt::format("q{}", index + 1);
    balls_[name] = balls_to_json(answer.query_data.balls, answer.query_scale);
    std::string html = fmt::format("<section id=\"query-{}\">\n<h2>{}</h2>\n", index + 1,
                                   is_single() ? "Matches" : shown(file_name(answer.query)));
    const std::string caption = shown(answer.query);
    html += fmt::format(
        "<div class=\"asked\">\n<button type=\"button\" class=\"look\" data-query=\"{0}\" "
        "data-match=\"{0}\" data-asked=\"\" data-caption=\"{1}\">{2}</button>\n<div>\n"
        "<p class=\"soft\">Query</p>\n<p class=\"name\">{1}</p>\n<p class=\"soft\">R {3:.4g}, {4} "
        "balls</p>\n</div>\n</div>\n",
        name, caption, image(answer.query_data, "Balls of " + caption), answer.query_scale,
        answer.query_data.balls.size());
    if (answer.result.matches.empty()) {
      return html + "<p class=\"nothing\">There are no matches.</p>\n</section>\n";
    }
    html += "<ol class=\"matches\">\n";
    for (std::size_t match = 0; match < answer.result.matches.size(); ++match) {
      html += card(answer, name, match);
    }
    html += "</ol>\n";
    if (options_.is_explained) html += explanations(answer);
    return html + "</section>\n";
  }

  std::string card(const QueryAnswer& answer, const std::string& query, std::size_t index) {
    const Match& match = answer.result.matches[index];
    const ShapeData& data = answer.match_data[index];
    const double furthest = answer.result.matches.back().distance;
    const std::string name = fmt::format("m{}", match.id);
    if (!balls_.contains(name)) balls_[name] = balls_to_json(data.balls, match.scale);
    const std::string differ =
        options_.is_explained ? join(differing_balls(answer, index, highlighted_balls)) : "";
    const std::string hand =
        match.hand ? fmt::format(", hand: {}", std::string_view(to_string(*match.hand))) : "";
    return fmt::format(
        "<li>\n<button type=\"button\" class=\"look\" data-query=\"{}\" data-match=\"{}\" "
        "data-differ=\"{}\" data-asked=\"{}\" data-caption=\"{}\">{}</button>\n"
        "<div class=\"gauge\"><span style=\"--share: {:.3f}\"></span></div>\n"
        "<p class=\"facts\"><span class=\"rank\">{}</span><span>{:.6f}</span></p>\n"
        "<p class=\"name\">{}</p>\n<p class=\"soft\">{}</p>\n<p class=\"soft\">R {:.4g}{}</p>\n"
        "</li>\n",
        query, name, differ, shown(answer.query), shown(match.path),
        image(data, "Balls of " + shown(match.path)),
        furthest > 0 ? match.distance / furthest : 0.0, index + 1, match.distance,
        shown(file_name(match.path)), shown(folder_of(match.path)), match.scale, hand);
  }

  std::string explanations(const QueryAnswer& answer) const {
    std::string html;
    for (std::size_t index = 0; index < answer.result.matches.size(); ++index) {
      const Match& match = answer.result.matches[index];
      if (match.distance == 0) continue;
      std::string parts;
      for (std::size_t i = 0; i < match.parts.size(); ++i) {
        fmt::format_to(std::back_inserter(parts), "{}{} {:.0f}\u00A0%", i > 0 ? ", " : "",
                       answer.result.part_names[i], 100.0 * match.parts[i] / match.distance);
      }
      html += fmt::format(
          "<details{}>\n<summary>{}. {} <span class=\"soft\">{:.6f}: {}</span></summary>\n{}{}{}{}"
          "</details>\n",
          is_first_explained(answer, index) ? " open=\"open\"" : "", index + 1,
          shown(file_name(match.path)), match.distance, parts,
          lists(answer, index, "Radii by R", "ball", radii_of),
          lists(answer, index, "Walk sums", "step", walk_sums_of), numbers(match),
          ball_table(answer, index));
    }
    return html.empty() ? "" : "<h3>What makes the difference</h3>\n" + html;
  }

  static bool is_first_explained(const QueryAnswer& answer, std::size_t index) {
    return index == 0 || answer.result.matches[index - 1].distance == 0;
  }

  template <typename ListOf>
  static std::string lists(const QueryAnswer& answer, std::size_t index, const char* caption,
                           const char* label, const ListOf& list_of) {
    LineChart chart{.caption = caption, .x_label = label, .y_label = "", .series = {}};
    const auto add = [&](const char* name, std::span<const float> list) {
      LineSeries& series = chart.series.emplace_back();
      series.name = name;
      series.y.assign(list.begin(), list.end());
      for (std::size_t i = 0; i < list.size(); ++i) series.x.push_back(static_cast<double>(i + 1));
    };
    add("query", list_of(answer, answer.query_data));
    add("match", list_of(answer, answer.match_data[index]));
    const std::vector<std::string> names = {"query", "match"};
    const std::string svg = svg_line_chart(chart);
    if (svg.empty()) return "";
    return fmt::format("<figure>\n<figcaption>{}</figcaption>\n{}{}</figure>\n", caption,
                       html_legend(names, LegendKind::lines), svg);
  }

  static std::string numbers(const Match& match) {
    Table table{.caption = "The numbers that differ the most",
                .columns = {"number", "query", "match", "difference"},
                .rows = {}};
    for (const NumberDifference& number : match.differences) {
      table.rows.push_back({number.name, fmt::format("{:.4f}", number.query),
                            fmt::format("{:.4f}", number.match),
                            fmt::format("{:+.4f}", number.match - number.query)});
    }
    return table.rows.empty() ? "" : html_table(table);
  }

  static std::string ball_table(const QueryAnswer& answer, std::size_t index) {
    Table table{.caption = "The balls that differ the most, radii by R",
                .columns = {"ball", "query", "match", "difference"},
                .rows = {}};
    for (const BallDifference& ball : differing_balls(answer, index, highlighted_balls)) {
      table.rows.push_back({fmt::format("{}", ball.place + 1), fmt::format("{:.4f}", ball.query),
                            fmt::format("{:.4f}", ball.match),
                            fmt::format("{:+.4f}", ball.match - ball.query)});
    }
    return table.rows.empty() ? "" : html_table(table);
  }

  std::string balls() const {
    std::string json;
    for (const auto& [name, list] : balls_) {
      fmt::format_to(std::back_inserter(json), "{}\"{}\":{}", json.empty() ? "" : ",\n", name,
                     list);
    }
    return "<script type=\"application/json\" id=\"balls\">{" + json + "}</script>\n";
  }

  std::span<const QueryAnswer> answers_;
  QueryPageOptions options_;
  std::map<std::string, std::string> balls_;  ///< JSON by name
};

}  // namespace

std::string format_query_page(std::span<const QueryAnswer> answers,
                              const QueryPageOptions& options) {
  return QueryPage(answers, options).format();
}

}  // namespace mdbd
