#include "decompose/ball_output.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mdbd {
namespace {

using Json = nlohmann::ordered_json;

std::string format_lines(const BallDecomposition& decomposition, char separator) {
  std::string text;
  for (const Ball& ball : decomposition.balls) {
    fmt::format_to(std::back_inserter(text), "{1}{0}{2}{0}{3}{0}{4}\n", separator, ball.center.x(),
                   ball.center.y(), ball.center.z(), ball.radius);
  }
  return text;
}

Json json_balls(const BallDecomposition& decomposition) {
  Json balls = Json::array();
  for (const Ball& ball : decomposition.balls) {
    balls.push_back({ball.center.x(), ball.center.y(), ball.center.z(), ball.radius});
  }
  return balls;
}

Json json_contacts(const ContactGraph& graph) {
  Json contacts = Json::array();
  for (std::size_t i = 0; i < graph.neighbours.size(); ++i) {
    for (const std::uint32_t j : graph.neighbours[i]) {
      if (i < j) contacts.push_back({i, j});
    }
  }
  return contacts;
}

Json json_recipe(const Recipe& recipe) {
  Json entries = Json::object();
  for (const auto& [name, text] : to_entries(recipe)) {
    const Json number = Json::parse(text, nullptr, false);  // not every entry is a number
    entries[name] = number.is_discarded() ? Json(text) : number;
  }
  return entries;
}

}  // namespace

std::optional<BallFormat> ball_format_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".csv") return BallFormat::csv;
  if (ending == ".xyzr") return BallFormat::xyzr;
  if (ending == ".json") return BallFormat::json;
  return std::nullopt;
}

std::string format_csv(const BallDecomposition& decomposition) {
  return "x,y,z,r\n" + format_lines(decomposition, ',');
}

std::string format_xyzr(const BallDecomposition& decomposition) {
  return format_lines(decomposition, ' ');
}

std::string format_json(const DecomposedModel& model) {
  const BallDecomposition& decomposition = model.decomposition;
  const Json document = {{"model", model.path},
                         {"representation", model.representation},
                         {"statistics", Json::parse(model.statistics)},
                         {"scale", decomposition.scale},
                         {"termination", to_string(decomposition.termination)},
                         {"balls", json_balls(decomposition)},
                         {"upper_bounds", decomposition.upper_bounds},
                         {"certified", decomposition.is_certified},
                         {"contacts", json_contacts(model.contacts)},
                         {"certificate",
                          {{"containment_violation", model.certificate.containment_violation},
                           {"overlap_violation", model.certificate.overlap_violation},
                           {"maximality_gap", model.certificate.maximality_gap}}},
                         {"cost",
                          {{"distance_queries", decomposition.cost.distance_queries},
                           {"cells", decomposition.cost.cells}}},
                         {"recipe", json_recipe(model.recipe)}};
  return document.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string format_balls(const DecomposedModel& model, BallFormat format) {
  switch (format) {
    case BallFormat::csv:
      return format_csv(model.decomposition);
    case BallFormat::xyzr:
      return format_xyzr(model.decomposition);
    case BallFormat::json:
      break;
  }
  return format_json(model);
}

}  // namespace mdbd
