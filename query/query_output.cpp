#include "query/query_output.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/text_output.h"

namespace mdbd {
namespace {

/// Of a part in its distance, per cent; 0 where there is no distance.
double share(const Match& match, std::size_t part) {
  return match.distance > 0 ? 100 * match.parts[part] / match.distance : 0.0;
}

bool has_hands(const SearchResult& result) {
  return !result.matches.empty() && result.matches.front().hand.has_value();
}

void append_differences(const Match& match, std::string& table) {
  for (const NumberDifference& difference : match.differences) {
    fmt::format_to(std::back_inserter(table), "{:17}{}: {:.4f}, in the query {:.4f}\n", "",
                   difference.name, difference.match, difference.query);
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

nlohmann::ordered_json to_json(const QueryAnswer& answer) {
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
    matches.push_back(std::move(object));
  }
  nlohmann::ordered_json object = {{"query", answer.query}, {"exact", !answer.recall.has_value()}};
  if (answer.recall) {
    object["recall"] = {{"share", answer.recall->share},
                        {"count", answer.recall->count},
                        {"sampled", answer.recall->sampled}};
  }
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

}  // namespace

std::string format_table(const SearchResult& result, const std::filesystem::path& directory,
                         bool is_explained) {
  if (result.matches.empty()) return {};
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
    if (is_explained) append_differences(match, table);
  }
  return table;
}

std::string describe_exactness(const QueryAnswer& answer) {
  if (!answer.recall) return "the answer is exact";
  return fmt::format(
      "approximate: recall@{} {:.3f} on {} sampled models of this collection (exact answer: drop "
      "--approx)",
      answer.recall->count, answer.recall->share, answer.recall->sampled);
}

std::string format_json(const QueryAnswer& answer) { return dump(to_json(answer)); }

std::string format_json(std::span<const QueryAnswer> answers) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const QueryAnswer& answer : answers) array.push_back(to_json(answer));
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
