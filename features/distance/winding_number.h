#pragma once

#include <vector>

#include "features/distance/triangle_tree.h"

namespace mdbd {

/// The generalised winding number of a triangle soup (Jacobson et al. 2013), evaluated
/// hierarchically (Barill et al., Fast Winding Numbers for Soups and Clouds, 2018): groups of
/// triangles far from the point count as one dipole each. About 1 inside an outward-oriented closed
/// surface and 0 outside; small holes, self-intersections and overlapping parts change it little.
class WindingNumber {
 public:
  /// @pre the tree outlives this object
  explicit WindingNumber(const TriangleTree& tree);

  /// The winding number at a point (object units), to about 0.1.
  double operator()(const Eigen::Vector3d& point) const;

 private:
  /// The dipoles of a node's children, in tree coordinates.
  struct Dipoles {
    float center[3][TreeNode::width];  ///< area-weighted centroid
    float normal[3][TreeNode::width];  ///< sum of area vectors / (4 pi)
    float reach[TreeNode::width];      ///< squared distance beyond which the dipole stands in
  };

  Dipoles summarise(const TreeNode& node) const;
  Eigen::Vector3d to_tree_coordinates(const Eigen::Vector3d& point) const;

  const TriangleTree& tree_;
  std::vector<Dipoles> dipoles_;  ///< one for each node of the tree
};

}  // namespace mdbd
