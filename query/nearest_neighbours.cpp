#include "query/nearest_neighbours.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include <flann/algorithms/dist.h>
#include <flann/algorithms/linear_index.h>

#include "features/core/errors.h"

namespace mdbd {
namespace {

void require_usable(std::span<const float> values) {
  const bool usable = std::ranges::all_of(values, [](float value) {
    return std::abs(value) <= NearestNeighbours::largest_component;  // false for NaN
  });
  if (!usable) throw InvalidInput("a vector holds a value that is not finite or far too large");
}

std::size_t row_count(const std::vector<float>& values, std::size_t dimension) {
  if (dimension == 0) throw InvalidInput("vectors need at least one dimension");
  if (values.size() % dimension != 0) {
    throw InvalidInput(std::to_string(values.size()) +
                       " values are no whole number of vectors of " + std::to_string(dimension));
  }
  return values.size() / dimension;
}

}  // namespace

struct NearestNeighbours::Index {
  Index(std::vector<float> vectors, std::size_t vector_dimension, PointNorm point_norm)
      : values(std::move(vectors)),
        dimension(vector_dimension),
        rows(row_count(values, dimension)),
        norm(point_norm) {
    require_usable(values);
    const flann::Matrix<float> matrix(values.data(), rows, dimension);
    if (norm == PointNorm::l1) linear.emplace<flann::LinearIndex<flann::L1<float>>>(matrix);
    if (norm == PointNorm::l2) linear.emplace<flann::LinearIndex<flann::L2<float>>>(matrix);
  }

  std::vector<float> values;
  std::size_t dimension;
  std::size_t rows;
  PointNorm norm;
  /// Points into values.
  std::variant<std::monostate, flann::LinearIndex<flann::L1<float>>,
               flann::LinearIndex<flann::L2<float>>>
      linear;
};

NearestNeighbours::NearestNeighbours(std::vector<float> values, std::size_t dimension,
                                     PointNorm norm)
    : index_(std::make_unique<Index>(std::move(values), dimension, norm)) {}

NearestNeighbours::~NearestNeighbours() = default;
NearestNeighbours::NearestNeighbours(NearestNeighbours&&) noexcept = default;
NearestNeighbours& NearestNeighbours::operator=(NearestNeighbours&&) noexcept = default;

std::size_t NearestNeighbours::size() const { return index_->rows; }

std::vector<Neighbour> NearestNeighbours::search(std::span<const float> query,
                                                 std::size_t k) const {
  if (query.size() != index_->dimension) {
    throw InvalidInput("a query of " + std::to_string(query.size()) +
                       " numbers against vectors of " + std::to_string(index_->dimension));
  }
  require_usable(query);
  const std::size_t count = std::min(k, index_->rows);
  if (count == 0) return {};

  std::vector<float> point(query.begin(), query.end());
  const flann::Matrix<float> queries(point.data(), 1, point.size());
  flann::SearchParams params;
  params.use_heap = flann::FLANN_True;  // the result set that orders equal distances by row
  std::vector<std::vector<std::size_t>> rows;
  std::vector<std::vector<float>> distances;
  std::visit(
      [&](auto& linear) {
        if constexpr (!std::is_same_v<decltype(linear), std::monostate&>) {
          linear.knnSearch(queries, rows, distances, count, params);
        }
      },
      index_->linear);

  std::vector<Neighbour> neighbours(rows[0].size());
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    const double distance = distances[0][i];  // FLANN's L2 is squared
    neighbours[i] = {rows[0][i], index_->norm == PointNorm::l2 ? std::sqrt(distance) : distance};
  }
  return neighbours;
}

}  // namespace mdbd
