#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "query/metric_block.h"
#include "store/vector_table.h"

namespace mdbd {

/// A map of vectors to a few numbers whose norm never exceeds the distance of the vectors, so that
/// the near ones can be found among sketches: |s(f) - s(g)| <= d(f, g).
///
/// - Euclidean blocks: the numbers along the principal axes with the largest variance of all
///   blocks. A rotation keeps L2, leaving numbers out shortens it, and the L2 norm of the whole is
///   at most the sum of the norms of its blocks.
/// - L1 blocks: sums of numbers with signs, each number in one sum: |sum f - sum g| is at most the
///   L1 distance. Numbers that vary together, or against each other, are summed: clusters of lines
///   through the origin, on which the variation of each number over the collection is a point.
///
/// What fits the collection is found from a sample of it, always the same. A sketch of any
/// collection bounds the distances of any vectors, it just serves other ones less well.
class MetricSketch {
 public:
  /// Components above this magnitude, weighted or not, would overflow in single precision.
  static constexpr float largest_component = 1e15F;

  /// @param blocks of the metric, all of one norm, with a weight above 0 in one of them
  /// @param size how many numbers a sketch has at most
  /// @pre the collection is not empty, and all blocks lie within its vectors
  MetricSketch(const VectorTable& collection, std::span<const MetricBlock> blocks,
               std::size_t size);

  /// One number of a sketch: a weighted sum of a vector's numbers less those of one vector of the
  /// collection.
  struct Axis {
    struct Term {
      std::size_t index;
      double coefficient;
    };
    std::vector<Term> terms;
    double offset = 0.0;
  };

  /// What axes(), norm() and largest_weight() of another one gave.
  MetricSketch(std::vector<Axis> axes, PointNorm norm, double largest_weight)
      : axes_(std::move(axes)), norm_(norm), largest_weight_(largest_weight) {}

  std::span<const Axis> axes() const { return axes_; }
  double largest_weight() const { return largest_weight_; }
  std::size_t size() const { return axes_.size(); }
  PointNorm norm() const { return norm_; }

  /// Writes the sketch of a vector to `sketch`, which has size() numbers.
  void write(std::span<const float> vector, std::span<float> sketch) const;

  /// What is to be taken off a distance of sketches before it bounds that of their vectors:
  /// sketches are rounded, vectors far from the origin more.
  /// @param magnitude of the larger vector: the sum of the magnitudes of its components
  double margin(double magnitude) const;

 private:
  std::vector<Axis> axes_;
  PointNorm norm_;
  double largest_weight_ = 0.0;
};

}  // namespace mdbd
