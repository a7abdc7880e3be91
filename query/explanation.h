#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "query/answer_query.h"

/// What makes the difference between a query and a match, beyond the numbers of the signature that
/// was searched by: the lists of mdbd-100, which are there whatever that was, and the balls.
/// @pre everywhere: the answer has the data of its query and matches (QueryOptions::has_data)
namespace mdbd {

/// The scaled radii of mdbd-100, r_i/R in order of placement, and its walk sums.
std::span<const float> radii_of(const QueryAnswer& answer, const ShapeData& data);
std::span<const float> walk_sums_of(const QueryAnswer& answer, const ShapeData& data);

/// A place in the order of placement whose balls differ.
struct BallDifference {
  std::size_t place = 0;  ///< from 0
  float query = 0.0F;     ///< r/R of the query's ball; 0 if it has none
  float match = 0.0F;
};

/// The balls among those of mdbd-100 whose scaled radii differ the most, the largest difference
/// first; none that are equal.
std::vector<BallDifference> differing_balls(const QueryAnswer& answer, std::size_t match,
                                            std::size_t most);

/// A list as a picture on one line, a block character of one to eight eighths for each value, and a
/// space for 0.
/// @param highest what is shown as a full block
std::string sparkline(std::span<const float> values, float highest);

}  // namespace mdbd
