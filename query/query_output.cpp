#include "query/query_output.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/text_output.h"
#include "query/explanation.h"

namespace mdbd {
namespace {

constexpr std::size_t explained_balls = 3;

/// Of a part in its distance, per cent; 0 where there is no distance.
double share(const Match& match, std::size_t part) {
  return match.distance > 0 ? 100 * match.parts[part] / match.distance : 0.0;
}

bool has_hands(const SearchResult& result) {
  return !result.matches.empty() && result.matches.front().hand.has_value();
}

void append_differences(const Match& match, std::string& table) {
  for (const NumberDifference& difference : match.differences) {
    fmt::format_to(std::back_inserter(table), "{:17}{}: {:.4f}, in the query {:.4f} ({:+.4f})\n",
                   "", difference.name, difference.match, difference.query,
                   difference.match - difference.query);
  }
}

/// A list of the query above that of a match, both to one scale.
void append_lists(std::string_view name, std::span<const float> query, std::span<const float> match,
                  std::string& table) {
  if (query.empty()) return;
  const float highest = std::max(std::ranges::max(query), std::ranges::max(match));
  fmt::format_to(std::back_inserter(table), "{0:17}{1:<9}  query  {2}\n{0:26}  match  {3}\n", "",
                 name, sparkline(query, highest), sparkline(match, highest));
}

/// "radius 0.1234 R at (1.2, 3.4, 5.6)", or that there is no such ball.
std::string describe_ball(const ShapeData& data, std::size_t place, float radius) {
  if (place >= data.balls.size()) return "none";
  const Eigen::Vector3d& center = data.balls[place].center;
  return fmt::format("{:.4f} R at ({:.4g}, {:.4g}, {:.4g})", radius, center.x(), center.y(),
                     center.z());
}

void append_explanation(const QueryAnswer& answer, std::size_t index, std::string& table) {
  append_differences(answer.result.matches[index], table);
  const ShapeData& query = answer.query_data;
  const ShapeData& match = answer.match_data[index];
  const std::vector<BallDifference> balls = differing_balls(answer, index, explained_balls);
  if (balls.empty()) return;
  append_lists("radii", radii_of(answer, query), radii_of(answer, match), table);
  append_lists("walk sums", walk_sums_of(answer, query), walk_sums_of(answer, match), table);
  for (const BallDifference& ball : balls) {
    fmt::format_to(std::back_inserter(table), "{:17}ball {}: {}, in the query {}\n", "",
                   ball.place + 1, describe_ball(match, ball.place, ball.match),
                   describe_ball(query, ball.place, ball.query));
  }
}

nlohmann::ordered_json to_json(const std::vector<NumberDifference>& differences) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const NumberDifference& difference : differences) {
    array.push_back(
        {{"number", difference.name}, {"query", difference.query}, {"match", difference.match}});
  }
  return array;
}

nlohmann::ordered_json to_json(const ShapeData& data, std::size_t place, float radius) {
  nlohmann::ordered_json object = {{"radius", radius}};
  if (place < data.balls.size()) {
    const Eigen::Vector3d& center = data.balls[place].center;
    object["center"] = {center.x(), center.y(), center.z()};
  }
  return object;
}

nlohmann::ordered_json differing_balls_to_json(const QueryAnswer& answer, std::size_t index) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const BallDifference& ball : differing_balls(answer, index, explained_balls)) {
    array.push_back({{"ball", ball.place + 1},
                     {"query", to_json(answer.query_data, ball.place, ball.query)},
                     {"match", to_json(answer.match_data[index], ball.place, ball.match)}});
  }
  return array;
}

/// The lists of mdbd-100 of a shape as members of its object.
void add_lists(const QueryAnswer& answer, const ShapeData& data, nlohmann::ordered_json& object) {
  object["radii"] = radii_of(answer, data);
  object["walk_sums"] = walk_sums_of(answer, data);
}

nlohmann::ordered_json to_json(const QueryAnswer& answer, bool is_explained) {
  nlohmann::ordered_json matches = nlohmann::ordered_json::array();
  for (const Match& match : answer.result.matches) {
    nlohmann::ordered_json object = {{"rank", matches.size() + 1},
                                     {"id", match.id},
                                     {"path", match.path},
                                     {"distance", match.distance}};
    for (std::size_t i = 0; i < match.parts.size(); ++i) {
      object[fmt::format("{}_distance", answer.result.part_names[i])] = match.parts[i];
    }
    object["scale"] = match.scale;
    if (match.hand) object["hand"] = to_string(*match.hand);
    if (!match.differences.empty()) object["differences"] = to_json(match.differences);
    if (is_explained) {
      const std::size_t index = matches.size();
      add_lists(answer, answer.match_data[index], object);
      object["balls"] = differing_balls_to_json(answer, index);
    }
    matches.push_back(std::move(object));
  }
  nlohmann::ordered_json object = {{"query", answer.query}, {"exact", !answer.recall.has_value()}};
  if (answer.recall) {
    object["recall"] = {{"share", answer.recall->share},
                        {"count", answer.recall->count},
                        {"sampled", answer.recall->sampled}};
  }
  if (is_explained) add_lists(answer, answer.query_data, object);
  object["matches"] = std::move(matches);
  return object;
}

std::string dump(const nlohmann::ordered_json& document) {
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string csv_header(const SearchResult& result, bool has_hand) {
  std::string header = "rank,id,path,distance,";
  for (const std::string_view name : result.part_names) header += fmt::format("{}_distance,", name);
  return header + (has_hand ? "scale,hand\n" : "scale\n");
}

/// @param prefix of each line
void append_csv(const SearchResult& result, const std::string& prefix, std::string& csv) {
  int rank = 0;
  for (const Match& match : result.matches) {
    fmt::format_to(std::back_inserter(csv), "{}{},{},{},{},", prefix, ++rank, match.id,
                   csv_field(match.path), match.distance);
    for (const double part : match.parts) fmt::format_to(std::back_inserter(csv), "{},", part);
    fmt::format_to(std::back_inserter(csv), "{}", match.scale);
    if (match.hand) fmt::format_to(std::back_inserter(csv), ",{}", to_string(*match.hand));
    csv += '\n';
  }
}

/// @param explain appends the lines below the match of an index; empty: none, and no shares
std::string make_table(const SearchResult& result, const std::filesystem::path& directory,
                       const std::function<void(std::size_t, std::string&)>& explain) {
  if (result.matches.empty()) return {};
  const bool is_explained = explain != nullptr;
  std::string table = fmt::format("{:>4}  {:>9}  ", "rank", "distance");
  const std::size_t parts = is_explained ? result.part_names.size() : 0;
  for (std::size_t i = 0; i < parts; ++i) table += fmt::format("{:>10}%  ", result.part_names[i]);
  if (has_hands(result)) table += fmt::format("{:<8}  ", "hand");
  table += "model\n";
  int rank = 0;
  for (const Match& match : result.matches) {
    fmt::format_to(std::back_inserter(table), "{:>4}  {:>9.6f}  ", ++rank, match.distance);
    for (std::size_t i = 0; i < parts; ++i) table += fmt::format("{:>11.0f}  ", share(match, i));
    if (match.hand) table += fmt::format("{:<8}  ", to_string(*match.hand));
    table += shown_path(match.path, directory) + '\n';
    if (is_explained) explain(static_cast<std::size_t>(rank - 1), table);
  }
  return table;
}

}  // namespace

std::string describe_exactness(const QueryAnswer& answer) {
  if (!answer.recall) return "the answer is exact";
  return fmt::format(
      "approximate: recall@{} {:.3f} on {} sampled models of this collection (exact answer: drop "
      "--approx)",
      answer.recall->count, answer.recall->share, answer.recall->sampled);
}

std::string format_table(const SearchResult& result, const std::filesystem::path& directory) {
  return make_table(result, directory, nullptr);
}

std::string format_explained_table(const QueryAnswer& answer,
                                   const std::filesystem::path& directory) {
  return make_table(answer.result, directory, [&](std::size_t match, std::string& table) {
    append_explanation(answer, match, table);
  });
}

std::string format_json(const QueryAnswer& answer, bool is_explained) {
  return dump(to_json(answer, is_explained));
}

std::string format_json(std::span<const QueryAnswer> answers, bool is_explained) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const QueryAnswer& answer : answers) array.push_back(to_json(answer, is_explained));
  return dump(array);
}

std::string format_csv(const SearchResult& result) {
  std::string csv = csv_header(result, has_hands(result));
  append_csv(result, "", csv);
  return csv;
}

std::string format_csv(std::span<const QueryAnswer> answers) {
  if (answers.empty()) return {};
  const bool has_hand = std::ranges::any_of(
      answers, [](const QueryAnswer& answer) { return has_hands(answer.result); });
  std::string csv = "query," + csv_header(answers.front().result, has_hand);
  for (const QueryAnswer& answer : answers) {
    append_csv(answer.result, csv_field(answer.query) + ',', csv);
  }
  return csv;
}

}  // namespace mdbd
