#pragma once

#include <vector>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// How much of a surface has an inside on one side and an outside on the other, so far as the
/// generalised winding number decides it: just off a closed surface it is near 1 and 0, off a sheet
/// 1/2 and -1/2, off a double sheet 0 and 0. Shares of area, from 0 to 1.
struct Enclosure {
  double share = 1.0;               ///< of the whole surface
  std::vector<double> part_shares;  ///< of each part; the whole's where it is too small to tell
};

/// Looks at the winding number `depth` off a thousand points that are spread evenly over the area.
/// @param part_of for each face the number of its part, from 0 without gaps
/// @param depth object units, above 0: what is thinner counts as enclosing nothing
Enclosure measure_enclosure(const TriangleMesh& mesh, const std::vector<std::uint32_t>& part_of,
                            double depth);

}  // namespace mdbd
