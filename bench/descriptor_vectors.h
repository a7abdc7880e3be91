#pragma once

#include <cstddef>

#include "store/vector_table.h"

/// Vectors for benchmarks of the search, in clusters as those of real collections; the same at
/// every run.
namespace mdbd {

/// Vectors of 100 numbers whose two halves have, along axes of a cosine transform, the variances
/// that the radii and walk sums of mdbd-100 have over 2,148 real models (lpsb, kicad, ldraw,
/// coseg_large): 98 % of the whole in five components. Twenty to a cluster.
VectorTable mdbd_100_vectors(std::size_t count);

/// Blends of signatures mdbd-fused of a thousand shapes made of random balls: each cluster blends
/// two, and each member of it another one in.
VectorTable mdbd_fused_vectors(std::size_t count);

}  // namespace mdbd
