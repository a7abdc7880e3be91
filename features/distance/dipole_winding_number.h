#pragma once

#include <span>
#include <vector>

#include "features/distance/point_tree.h"

namespace mdbd {

/// The generalised winding number of oriented points (Barill et al., Fast Winding Numbers for Soups
/// and Clouds, 2018): each point stands for a piece of the surface, a dipole of its area along its
/// normal; groups far away count as one dipole. About 1 inside outward-oriented points of a closed
/// surface and 0 outside; noise, outliers, small holes and uneven density change it little.
///
/// The term of a point is smoothed at the size of its piece, so that it stays bounded next to it:
/// across a plane the sum rises from 0 to 1 within that size.
class DipoleWindingNumber {
 public:
  /// @param area_vectors for each of the tree's points, in the order of PointTree::points(): the
  ///        area of its piece times its outward normal; object units squared
  /// @pre the tree outlives this object
  DipoleWindingNumber(const PointTree& tree, std::span<const Eigen::Vector3d> area_vectors);

  /// The winding number at a point (object units), to about 0.1.
  double operator()(const Eigen::Vector3d& point) const;

 private:
  static constexpr int width = TreeNode::width;

  /// Eight dipoles in tree coordinates, [axis][lane]: the children of a node, or points of a leaf.
  struct Dipoles {
    float center[3][width];
    float normal[3][width];  ///< area vector / (4 pi)
    float smoothing[width];  ///< added to squared distances: the area of a point's piece
    float reach[width];      ///< squared distance beyond which a child counts as one dipole
  };

  Dipoles summarise(const TreeNode& node, std::span<const Eigen::Vector3d> area_vectors) const;
  Dipoles gather(std::uint32_t first, std::uint32_t count,
                 std::span<const Eigen::Vector3d> area_vectors) const;
  static void evaluate(const Dipoles& dipoles, const float (&p)[3], float (&terms)[width],
                       float (&squared)[width]);

  const PointTree& tree_;
  std::vector<Dipoles> nodes_;   ///< one for each node of the tree
  std::vector<Dipoles> blocks_;  ///< one for each block of the tree
};

}  // namespace mdbd
