#include "features/shape_unit.h"

#include <nlohmann/json.hpp>

#include "features/core/length_unit.h"

namespace mdbd {

std::string declare_unit(const std::string& statistics, std::string_view unit) {
  if (recorded_millimetres(statistics)) return statistics;
  auto record = nlohmann::ordered_json::parse(statistics, nullptr, false);
  if (!record.is_object()) record = nlohmann::ordered_json::object();
  record["unit"] = unit;
  record["unit_declared"] = true;
  return record.dump();
}

std::optional<double> recorded_millimetres(const std::string& statistics) {
  const auto record = nlohmann::json::parse(statistics, nullptr, false);
  if (!record.is_object() || !record.contains("unit") || !record["unit"].is_string()) {
    return std::nullopt;
  }
  return millimetres_of(record["unit"].get<std::string>());
}

}  // namespace mdbd
