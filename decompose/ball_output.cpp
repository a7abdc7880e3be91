#include "decompose/ball_output.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "features/core/errors.h"

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

// The lightness of discs in a picture, per cent.
constexpr double lightest = 75.0;
constexpr double darkest = 25.0;

std::pair<Eigen::Vector2d, Eigen::Vector2d> bounding_rectangle(const PlanarDomain& domain) {
  Eigen::Vector2d lowest = domain.front().front();
  Eigen::Vector2d highest = lowest;
  for (const Outline& outline : domain) {
    for (const Eigen::Vector2d& point : outline) {
      lowest = lowest.cwiseMin(point);
      highest = highest.cwiseMax(point);
    }
  }
  return {lowest, highest};
}

std::string path_data(const PlanarDomain& domain) {
  std::string data;
  for (const Outline& outline : domain) {
    char command = 'M';
    for (const Eigen::Vector2d& point : outline) {
      fmt::format_to(std::back_inserter(data), "{}{} {}", command, point.x(), point.y());
      command = 'L';
    }
    data += 'Z';
  }
  return data;
}

}  // namespace

std::optional<BallFormat> ball_format_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".csv") return BallFormat::csv;
  if (ending == ".xyzr") return BallFormat::xyzr;
  if (ending == ".json") return BallFormat::json;
  if (ending == ".svg") return BallFormat::svg;
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

std::string format_svg(const DecomposedModel& model) {
  if (model.outlines.empty()) {
    throw InvalidInput(
        fmt::format("{}: only domains in the plane are drawn, and this is a solid", model.path));
  }
  const auto [lowest, highest] = bounding_rectangle(model.outlines);
  const Eigen::Vector2d size = highest - lowest;
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(0.02 * size.maxCoeff());
  const Eigen::Vector2d corner = lowest - margin;
  const Eigen::Vector2d extent = size + 2.0 * margin;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\">\n"
      "<path fill=\"#eee\" stroke=\"#000\" stroke-width=\"{}\" d=\"{}\"/>\n",
      corner.x(), corner.y(), extent.x(), extent.y(), 0.001 * extent.maxCoeff(),
      path_data(model.outlines));
  const std::vector<Ball>& discs = model.decomposition.balls;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(discs.size());
    fmt::format_to(std::back_inserter(text),
                   "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"hsl(210,60%,{:.0f}%)\"/>\n",
                   discs[i].center.x(), discs[i].center.y(), discs[i].radius,
                   lightest + (darkest - lightest) * share);
  }
  return text + "</svg>\n";
}

std::string format_balls(const DecomposedModel& model, BallFormat format) {
  switch (format) {
    case BallFormat::csv:
      return format_csv(model.decomposition);
    case BallFormat::xyzr:
      return format_xyzr(model.decomposition);
    case BallFormat::svg:
      return format_svg(model);
    case BallFormat::json:
      break;
  }
  return format_json(model);
}

}  // namespace mdbd
