#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "features/implicit/surface.h"

namespace mdbd {

/// A solid of constructive solid geometry: unions and intersections of the insides and outsides of
/// surfaces.
///
/// Its value at a point, the maximum (union) and minimum (intersection) of the signed distances of
/// the surfaces, is positive inside and 1-Lipschitz, so that its magnitude is never more than the
/// distance to the boundary. It may be less.
///
/// The solid is regular: walls without thickness, where parts of a union touch, and skins without
/// thickness, where a difference leaves a face, do not count.
class CsgSolid {
 public:
  /// One step of the evaluation, on a stack of values.
  struct Step {
    enum class Kind { surface, maximum, minimum };
    Kind kind = Kind::surface;
    std::uint32_t count = 0;  ///< which surface, or how many values are replaced by one
    double sign = 1.0;        ///< of the surface's distance
    std::uint32_t begin = 0;  ///< the first step of what it takes
  };

  /// The number of surfaces.
  std::size_t size() const { return surfaces_.size(); }
  const std::vector<Surface>& surfaces() const { return surfaces_; }

  /// A box that encloses the solid; without bounds where it is not known to have any.
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }

  /// The signed distances of all surfaces at a point.
  void measure_surfaces(const Eigen::Vector3d& x, std::vector<double>& distances) const;

  /// The value that the surfaces' distances make.
  double value(const std::vector<double>& distances) const;

  /// The surfaces that pass within `reach` of a point and may decide the value there, in ascending
  /// order. The others can be forgotten in the ball of that radius.
  /// @param distances of the surfaces at the point
  std::vector<std::uint32_t> deciding_surfaces(const std::vector<double>& distances,
                                               double reach) const;

  /// Whether the solid is on one side, and the outside on another, of the surfaces that pass a
  /// point within a tolerance. Where more than two surfaces have a line in common, it may be taken
  /// for boundary though it is inside.
  bool is_boundary(const Eigen::Vector3d& x, double tolerance) const;

  /// Whether a point is inside; one on a wall without thickness is.
  bool contains(std::vector<double>& distances, double tolerance) const;

 private:
  friend class CsgBuilder;

  struct Signs {
    bool has_inside = false;
    bool has_outside = false;
  };
  Signs signs_around(std::vector<double>& distances, double tolerance) const;

  std::vector<Surface> surfaces_;
  std::vector<Step> steps_;  // in postfix order
  std::size_t depth_ = 0;    // of the stack
  Eigen::AlignedBox3d bounds_;
};

/// Puts a solid together, in postfix order. A surface that comes again is the same one.
class CsgBuilder {
 public:
  /// @param is_inside whether the inside or the outside of the surface is meant
  /// @param bounds of that side
  void add(const Surface& surface, bool is_inside, const Eigen::AlignedBox3d& bounds);

  /// The union or intersection of the last `count` things.
  void unite(std::size_t count);
  void intersect(std::size_t count);

  /// @pre one thing is left
  CsgSolid finish() &&;

 private:
  void combine(CsgSolid::Step::Kind kind, std::size_t count);

  CsgSolid solid_;
  std::vector<Eigen::AlignedBox3d> bounds_;  // of the things on the stack
  std::vector<std::uint32_t> begins_;        // where their steps begin
};

/// The whole space, and the box of nothing.
Eigen::AlignedBox3d unbounded_box();

}  // namespace mdbd
