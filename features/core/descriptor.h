#pragma once

#include <span>
#include <vector>

namespace mdbd {

/// The descriptor f of the paper's section 5 with the scaling by the enclosing ball:
/// f = { r_1/R … r_k/R , P_k^1 … P_k^m }.
///
/// `values` holds the k scaled radii, in order of placement, followed by the m walk sums; all are
/// dimensionless. A decomposition of fewer than k balls is padded with zeros. The precision is the
/// store's: single, so that a vector read back equals the vector computed.
struct Descriptor {
  std::vector<float> values;
  int radius_count = 0;         ///< k, how many of the values are radii
  bool walk_is_defined = true;  ///< false if no two balls touch; the walk sums are then zeros

  std::span<const float> radii() const { return std::span(values).first(radius_count); }
  std::span<const float> walk() const { return std::span(values).subspan(radius_count); }
};

}  // namespace mdbd
