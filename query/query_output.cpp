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

}  // namespace

std::string format_table(const SearchResult& result, const std::filesystem::path& directory) {
  if (result.matches.empty()) return {};
  std::string table = fmt::format("{:>4}  {:>9}  {}\n", "rank", "distance", "model");
  int rank = 0;
  for (const Match& match : result.matches) {
    fmt::format_to(std::back_inserter(table), "{:>4}  {:>9.6f}  {}\n", ++rank, match.distance.total,
                   shown_path(match.path, directory));
  }
  return table;
}

std::string format_json(const QueryAnswer& answer) {
  nlohmann::ordered_json matches = nlohmann::ordered_json::array();
  for (const Match& match : answer.result.matches) {
    matches.push_back({{"rank", matches.size() + 1},
                       {"id", match.id},
                       {"path", match.path},
                       {"distance", match.distance.total},
                       {"radii_distance", match.distance.radii},
                       {"walk_distance", match.distance.walk},
                       {"scale", match.scale}});
  }
  const nlohmann::ordered_json document = {
      {"query", answer.query}, {"exact", answer.result.exact}, {"matches", matches}};
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string format_csv(const SearchResult& result) {
  std::string csv = "rank,id,path,distance,radii_distance,walk_distance,scale\n";
  int rank = 0;
  for (const Match& match : result.matches) {
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{}\n", ++rank, match.id,
                   quote_csv(match.path), match.distance.total, match.distance.radii,
                   match.distance.walk, match.scale);
  }
  return csv;
}

}  // namespace mdbd
