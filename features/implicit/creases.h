#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "features/implicit/csg_solid.h"

namespace mdbd {

/// Where the surfaces of a solid meet: curves of two, points of three. Found by subdividing space
/// down to cells in which the surfaces are nearly flat and meet once; cells whose centre has a
/// value above half their diagonal hold no boundary and are left out.
///
/// Surfaces that are tangent where they meet have no crease there: what is closest to a point is
/// then the foot on one of them.
class Creases {
 public:
  /// @param tolerance within which points are on a surface, object units
  /// @throws InvalidInput if there are too many
  Creases(const CsgSolid& solid, double tolerance);

  /// A boundary point on a crease that is closest to x, if one is closer than `bound`.
  std::optional<Eigen::Vector3d> closest(const Eigen::Vector3d& x, double bound) const;

  /// The boundary points on creases that are locally farthest from x and farther than `bound`.
  std::vector<Eigen::Vector3d> farthest(const Eigen::Vector3d& x, double bound) const;

  /// Boundary points on creases, some in each cell.
  std::vector<Eigen::Vector3d> samples() const;

 private:
  /// The piece of a curve around a point of it, or a point where curves end.
  struct Crease {
    std::array<std::uint32_t, 2> surfaces;
    Eigen::Vector3d point;
    Eigen::Vector3d tangent;
    double reach;      ///< along the tangent, to both sides; zero for a point
    bool is_boundary;  ///< as a whole; else points of it have to be tried
  };

  struct Node {
    Eigen::Vector3d center;
    double half;
    std::uint32_t first_child = 0;  ///< in children_
    std::uint32_t child_count = 0;
    std::uint32_t first_crease = 0;
    std::uint32_t crease_count = 0;
  };

  /// A cell with what is near it.
  struct Cell {
    Eigen::Vector3d center;
    double half;
    int depth;
    std::vector<std::uint32_t> near;  // surfaces
    double radius() const;
  };

  std::optional<std::uint32_t> subdivide(const Eigen::Vector3d& center, double half, int depth);
  bool is_fine(const Cell& cell) const;
  void add_creases(const Cell& cell);
  void add_curve(const Cell& cell, std::uint32_t first, std::uint32_t second);
  void add_point(const Cell& cell, const std::array<std::uint32_t, 3>& surfaces);
  std::optional<Eigen::Vector3d> project(const Eigen::Vector3d& start, std::uint32_t first,
                                         std::uint32_t second) const;
  std::optional<Eigen::Vector3d> extreme_point(const Crease& crease, const Eigen::Vector3d& x,
                                               double direction) const;

  std::optional<Eigen::Vector3d> boundary_point(const Node& node, const Crease& crease,
                                                const Eigen::Vector3d& x, double direction) const;

  const CsgSolid& solid_;
  double tolerance_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> children_;
  std::vector<Crease> creases_;
  std::size_t cells_ = 0;
  std::optional<std::uint32_t> root_;
};

}  // namespace mdbd
