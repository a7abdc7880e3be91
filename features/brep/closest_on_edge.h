#pragma once

#include "features/brep/brep.h"

namespace mdbd {

/// The point of an edge that is closest to a point: in closed form on lines and circles; on other
/// curves by Newton's method between the nodes `segment` and `segment + 1` of the tessellation and
/// their neighbours.
Eigen::Vector3d closest_point(const BrepEdge& edge, std::size_t segment,
                              const Eigen::Vector3d& point);

}  // namespace mdbd
