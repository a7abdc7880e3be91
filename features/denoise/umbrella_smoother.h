#pragma once

#include <span>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "features/denoise/vertex_neighbours.h"

namespace mdbd {

/// One row for each vertex.
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Smooths vertices as a thin plate does: the result x minimises |x - y|² + t |U x|², y being the
/// noisy positions and U the umbrella operator, which takes a vertex to its offset from a weighted
/// mean of its neighbours (Kobbelt et al., Interactive Multi-Resolution Modeling on Arbitrary
/// Meshes, SIGGRAPH 1998). It does not shrink to first order, and it needs nothing of the faces,
/// which noise longer than their edges folds. Vertices of open edges have only their neighbours
/// along open edges, so that borders do not creep inward.
class UmbrellaSmoother {
 public:
  /// @param weights of the entries of `neighbours`, positive
  /// @pre there is one weight for each entry
  UmbrellaSmoother(const VertexNeighbours& neighbours, std::span<const double> weights);

  /// The smooth positions, by conjugate gradients with a bounded number of steps, the same for the
  /// three coordinates, so that a turned mesh takes the same steps.
  /// @param strength t >= 0
  /// @param start a guess, say the result of another strength
  Positions smooth(const Positions& noisy, double strength, const Positions& start) const;

  /// How much of the noise stays: the mean over vertices of the derivative of the smooth position
  /// by the noisy one. Computed for the regular triangle lattice and equal weights, where the
  /// umbrella operator has the eigenvalues 1 - (cos a + cos b + cos(a + b)) / 3.
  static double response(double strength);

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  Matrix umbrella_;
  Matrix transposed_;
  Eigen::VectorXd column_squares_;  // the diagonal of U^T U
};

}  // namespace mdbd
