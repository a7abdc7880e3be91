#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "query/metric_block.h"

namespace mdbd {

/// How vectors of one signature are compared: the distance that answers are ordered by, and the
/// blocks of numbers that it is the sum of, so that an index can bound it.
class SignatureMetric {
 public:
  virtual ~SignatureMetric() = default;

  /// The blocks of a vector with this many numbers, at least least_size(); all of one norm. What
  /// they add is the distance.
  virtual std::vector<MetricBlock> blocks(std::size_t size) const = 0;

  /// What a distance is made of.
  virtual std::vector<std::string_view> part_names() const = 0;
  virtual std::vector<double> parts(std::span<const float> f, std::span<const float> g) const = 0;
  virtual double distance(std::span<const float> f, std::span<const float> g) const = 0;

  /// What the number of a vector at an index says, for people.
  virtual std::string number_name(std::size_t index) const = 0;

  /// How many numbers a vector has at least.
  virtual std::size_t least_size() const = 0;
};

/// The similarity distance of mdbd-100 (paper, section 5.2), |f_R - g_R| + alpha |f_P - g_P|, a
/// metric but no Euclidean one. Its parts are "radii" and "walk", the latter without alpha.
/// @param radius_count k of the recipe, how many of the values are radii
/// @param walk_weight alpha, at least 0
std::unique_ptr<const SignatureMetric> similarity_metric(int radius_count, double walk_weight);

/// The L1 distance of mdbd-fused, with the parts of fused_parts.
std::unique_ptr<const SignatureMetric> fused_metric();

/// A metric of vectors that hold the numbers of compute_chirality() and then those of another
/// metric: that metric's distance and, by its norm, the length of the difference in chirality, as
/// the last part, "chirality". A mirrored twin is as far as the shape is chiral.
std::unique_ptr<const SignatureMetric> chiral_metric(std::unique_ptr<const SignatureMetric> base);

}  // namespace mdbd
