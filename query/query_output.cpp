#include "query/query_output.h"

#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/terminal.h"

namespace mdbd {
namespace {

std::string quote_csv(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char character : field) {
    if (character == '"') quoted += '"';
    quoted += character;
  }
  return quoted + '"';
}

std::string shown_path(const std::string& path, const std::filesystem::path& directory) {
  const std::filesystem::path relative = std::filesystem::path(path).lexically_relative(directory);
  const bool is_below = !relative.empty() && *relative.begin() != "..";
  return printable(is_below ? relative.string() : path);
}

/// Of a part in its distance, per cent; 0 where there is no distance.
double share(const Match& match, std::size_t part) {
  return match.distance > 0 ? 100 * match.parts[part] / match.distance : 0.0;
}

}  // namespace

std::string format_table(const SearchResult& result, const std::filesystem::path& directory,
                         bool is_explained) {
  if (result.matches.empty()) return {};
  std::string table = fmt::format("{:>4}  {:>9}  ", "rank", "distance");
  const std::size_t parts = is_explained ? result.part_names.size() : 0;
  for (std::size_t i = 0; i < parts; ++i) table += fmt::format("{:>10}%  ", result.part_names[i]);
  table += "model\n";
  int rank = 0;
  for (const Match& match : result.matches) {
    fmt::format_to(std::back_inserter(table), "{:>4}  {:>9.6f}  ", ++rank, match.distance);
    for (std::size_t i = 0; i < parts; ++i) table += fmt::format("{:>11.0f}  ", share(match, i));
    table += shown_path(match.path, directory) + '\n';
  }
  return table;
}

std::string format_json(const QueryAnswer& answer) {
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
    matches.push_back(std::move(object));
  }
  const nlohmann::ordered_json document = {
      {"query", answer.query}, {"exact", answer.result.exact}, {"matches", matches}};
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string format_csv(const SearchResult& result) {
  std::string csv = "rank,id,path,distance,";
  for (const std::string_view name : result.part_names) csv += fmt::format("{}_distance,", name);
  csv += "scale\n";
  int rank = 0;
  for (const Match& match : result.matches) {
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},", ++rank, match.id, quote_csv(match.path),
                   match.distance);
    for (const double part : match.parts) fmt::format_to(std::back_inserter(csv), "{},", part);
    fmt::format_to(std::back_inserter(csv), "{}\n", match.scale);
  }
  return csv;
}

}  // namespace mdbd
