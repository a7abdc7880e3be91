#include "query/duplicates_output.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/text_output.h"

namespace mdbd {
namespace {

// Up to this R is the same for people: decimation and single precision move it as much.
constexpr double shown_ratio = 0.002;
// As far as files with single precision deviate.
constexpr double least_shown_deviation = 1e-5;

std::string shown_size(double ratio) {
  if (std::abs(ratio - 1.0) < shown_ratio) return "same size";
  return fmt::format("x {:.4g}", ratio);
}

std::string shown_deviation(const DuplicatePair& pair) {
  if (!pair.deviation) return "";
  if (*pair.deviation < least_shown_deviation) return ", same surface";
  return fmt::format(", surfaces within {:.2g} % of R", 100.0 * *pair.deviation);
}

std::string shown_hand(Hand hand) {
  switch (hand) {
    case Hand::same:
      return "same hand";
    case Hand::mirrored:
      return "mirrored";
    case Hand::none:
      return "no hand";
    case Hand::unclear:
      return "hand unclear";
  }
  return "";
}

nlohmann::ordered_json to_json(std::optional<double> number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json to_json(const DuplicateGroup& group) {
  nlohmann::ordered_json models = nlohmann::ordered_json::array();
  for (const ShapeRecord& model : group.models) {
    models.push_back({{"id", model.id},
                      {"path", model.path},
                      {"format", model.format},
                      {"scale", model.scale},
                      {"file_size", model.file_size}});
  }
  nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
  for (const DuplicatePair& pair : group.pairs) {
    pairs.push_back({{"first", group.models[pair.first].id},
                     {"second", group.models[pair.second].id},
                     {"distance", pair.distance},
                     {"radii_distance", pair.radii_distance},
                     {"deviation", to_json(pair.deviation)},
                     {"scale_ratio", pair.scale_ratio},
                     {"hand", to_string(pair.hand)},
                     {"same_bytes", pair.has_same_bytes}});
  }
  return {{"keep", group.models.front().id}, {"models", models}, {"pairs", pairs}};
}

}  // namespace

std::string format_duplicates_table(const DuplicateReport& report,
                                    const std::filesystem::path& directory) {
  std::string text;
  for (const DuplicateGroup& group : report.groups) {
    fmt::format_to(std::back_inserter(text), "{}keep  {}\n", text.empty() ? "" : "\n",
                   shown_path(group.models.front().path, directory));
    for (const DuplicatePair& pair : group.pairs) {
      if (pair.first != 0) continue;
      fmt::format_to(std::back_inserter(text), "      {}\n        {}, distance {:.4f}, {}, {}{}\n",
                     shown_path(group.models[pair.second].path, directory),
                     pair.has_same_bytes ? "same bytes" : "other bytes", pair.distance,
                     shown_size(pair.scale_ratio), shown_hand(pair.hand), shown_deviation(pair));
    }
  }
  return text;
}

std::string format_duplicates_json(const DuplicateReport& report, double threshold) {
  nlohmann::ordered_json groups = nlohmann::ordered_json::array();
  for (const DuplicateGroup& group : report.groups) groups.push_back(to_json(group));
  const nlohmann::ordered_json document = {{"compared", report.compared},
                                           {"threshold", threshold},
                                           {"surfaces_compared", report.measured},
                                           {"surfaces_not_compared", report.not_measured},
                                           {"groups", groups}};
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string format_duplicates_csv(const DuplicateReport& report) {
  std::string csv =
      "group,keep,first,first_path,second,second_path,distance,radii_distance,deviation,scale_"
      "ratio,"
      "hand,same_bytes\n";
  std::size_t number = 0;
  for (const DuplicateGroup& group : report.groups) {
    ++number;
    for (const DuplicatePair& pair : group.pairs) {
      const ShapeRecord& first = group.models[pair.first];
      const ShapeRecord& second = group.models[pair.second];
      fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{},{},{},{},{}\n", number,
                     group.models.front().id, first.id, csv_field(first.path), second.id,
                     csv_field(second.path), pair.distance, pair.radii_distance,
                     pair.deviation ? fmt::to_string(*pair.deviation) : "", pair.scale_ratio,
                     to_string(pair.hand), pair.has_same_bytes ? "yes" : "no");
    }
  }
  return csv;
}

}  // namespace mdbd
