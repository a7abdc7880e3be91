#include "report/format_report.h"

namespace mdbd {

std::string format_report_json(const Report& report) {
  using nlohmann::ordered_json;
  ordered_json provenance = ordered_json::object();
  for (const auto& [name, value] : report.provenance) provenance[name] = value;
  ordered_json document = {{"title", report.title},
                           {"summary", report.summary},
                           {"provenance", std::move(provenance)},
                           {"notes", report.notes}};
  for (const auto& [name, value] : report.data.items())
    document.emplace(name, nlohmann::ordered_json(value));
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace mdbd
