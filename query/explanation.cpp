#include "query/explanation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace mdbd {

std::span<const float> radii_of(const QueryAnswer& answer, const ShapeData& data) {
  return std::span(data.signature).first(answer.radius_count);
}

std::span<const float> walk_sums_of(const QueryAnswer& answer, const ShapeData& data) {
  return std::span(data.signature).subspan(answer.radius_count);
}

std::vector<BallDifference> differing_balls(const QueryAnswer& answer, std::size_t match,
                                            std::size_t most) {
  const std::span<const float> query = radii_of(answer, answer.query_data);
  const std::span<const float> other = radii_of(answer, answer.match_data[match]);
  std::vector<BallDifference> differences;
  for (std::size_t place = 0; place < query.size(); ++place) {
    if (query[place] != other[place]) differences.push_back({place, query[place], other[place]});
  }
  std::ranges::stable_sort(differences, std::ranges::greater{}, [](const BallDifference& ball) {
    return std::abs(ball.query - ball.match);
  });
  differences.resize(std::min(differences.size(), most));
  return differences;
}

std::string sparkline(std::span<const float> values, float highest) {
  constexpr std::array<std::string_view, 9> blocks = {
      " ", "\u2581", "\u2582", "\u2583", "\u2584", "\u2585", "\u2586", "\u2587", "\u2588"};
  std::string line;
  for (const float value : values) {
    const float eighths = highest > 0 ? std::ceil(8.0F * value / highest) : 0.0F;
    line += blocks[static_cast<std::size_t>(std::clamp(eighths, 0.0F, 8.0F))];
  }
  return line;
}

}  // namespace mdbd
