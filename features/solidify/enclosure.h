#pragma once

#include <cstdint>
#include <vector>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A point of a surface where it was looked at.
struct EnclosureSample {
  std::uint32_t face;
  bool is_bounding;  ///< whether an inside is on one side and an outside on the other
};

/// How much of a surface has an inside on one side and an outside on the other, so far as the
/// generalised winding number decides it: just off a closed surface it is near 1 and 0, off a sheet
/// 1/2 and -1/2, off a double sheet 0 and 0. Shares of area, from 0 to 1.
struct Enclosure {
  double share = 1.0;                    ///< of the whole surface
  std::vector<EnclosureSample> samples;  ///< spread evenly over the area
};

/// Looks at the winding number `depth` off a thousand points that are spread evenly over the area.
/// @param depth object units, above 0: what is thinner counts as enclosing nothing
Enclosure measure_enclosure(const TriangleMesh& mesh, double depth);

/// The share of each part of the surface; the whole's where a part is too small to tell.
/// @param part_of for each face the number of its part, below `parts`
std::vector<double> share_of_parts(const Enclosure& enclosure,
                                   const std::vector<std::uint32_t>& part_of, std::uint32_t parts);

}  // namespace mdbd
