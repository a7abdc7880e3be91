#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace mdbd {

/// The length of a difference of vectors.
enum class PointNorm {
  l1,  ///< sum of the absolute values
  l2   ///< Euclidean
};

/// A row of a NearestNeighbours with its distance to the query.
struct Neighbour {
  std::size_t row = 0;
  double distance = 0.0;  ///< the norm of the difference; computed in single precision
};

/// Exact nearest neighbours over a fixed set of vectors. A thin wrapper over FLANN's
/// linear index: deterministic, without build time. Thread-safe once built.
class NearestNeighbours {
 public:
  /// Components above this magnitude would overflow the squared distance in single precision.
  static constexpr float largest_component = 1e15F;

  /// @param values the vectors one after the other, `dimension` values each; may be empty
  /// @throws InvalidInput if dimension is 0, values is no whole number of vectors, or a value is
  /// not
  ///         finite or above largest_component
  NearestNeighbours(std::vector<float> values, std::size_t dimension,
                    PointNorm norm = PointNorm::l2);
  ~NearestNeighbours();
  NearestNeighbours(NearestNeighbours&&) noexcept;
  NearestNeighbours& operator=(NearestNeighbours&&) noexcept;

  std::size_t size() const;  ///< number of rows

  /// The k rows nearest to the query, or all rows if there are fewer, ordered by distance and, at
  /// equal distance, by row. The first rows of a larger k are those of a smaller one.
  /// @throws InvalidInput if the query has another dimension or a value the constructor refuses
  std::vector<Neighbour> search(std::span<const float> query, std::size_t k) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace mdbd
