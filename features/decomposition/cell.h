#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "features/decomposition/cube_bounds.h"
#include "features/decomposition/remaining_space.h"

namespace mdbd {

/// A cube of the octree with what is known of the balls centred in it. Object units.
///
/// `bound` only falls: no ball centred in the cell has a higher rank (see Preference), and so none
/// is larger. It rests on the placed balls nearby
/// and on a few witnesses of the boundary, inherited from the parent and found by measuring.
class Cell {
 public:
  Cell(const Eigen::Vector3d& center, double half_size, double bound);

  double bound() const { return bound_; }
  const Eigen::Vector3d& center() const { return center_; }
  double half_size() const { return half_size_; }

  /// Whether the centre has been measured.
  bool is_measured() const { return is_measured_; }

  /// Whether the bound accounts for all balls placed.
  bool is_current(const RemainingSpace& space) const {
    return is_solved_ && balls_seen_ == space.balls().size();
  }

  /// d_i at the centre, not its rank. @pre is_measured() and is_current()
  double value() const { return value_; }

  /// Whether another probe is likely to lower the bound more cheaply than a division.
  bool wants_probe() const { return next_probe() != Probe::none; }

  /// Lowers the bound by all witnesses known, without a distance query: by each alone, and if that
  /// leaves it above `enough`, by all together.
  void tighten(const RemainingSpace& space, double enough);

  /// The same with bounds over this cell that rest on all witnesses known.
  void tighten(const CubeBounds& bounds, double enough);

  /// All witnesses known: boundary points, balls outside, and placed balls.
  WitnessLanes witnesses(const RemainingSpace& space) const;

  /// Measures the centre and tightens the bound.
  void measure(RemainingSpace& space, double enough);

  /// Measures where that is likely to lower the bound most: outside the solid, across the medial
  /// axis from the boundary point nearest to the centre, or where the witnesses allow the most.
  /// @returns the point and an upper bound of d_i there: the balls far from the centre are left out
  std::pair<Eigen::Vector3d, double> probe(RemainingSpace& space, double enough);

  /// One of the eight children; they inherit bound and witnesses. @pre 0 <= octant < 8
  Cell child(int octant) const;

  /// One of the four children that cover what the cell has of the plane through its centre.
  /// @pre 0 <= quadrant < 4
  Cell planar_child(int quadrant) const;

  /// The largest distance of a point of the cell from another point.
  double reach(const Eigen::Vector3d& from) const;

 private:
  static constexpr std::size_t kept_witnesses = 5;
  static constexpr std::size_t nearby_balls = 3;
  static_assert(kept_witnesses + nearby_balls <= WitnessLanes::capacity);

  enum class Probe : std::uint8_t { none, outward, across, peak };

  void limit(double bound) { bound_ = std::min(bound_, bound); }
  double half_diagonal() const;
  Probe next_probe() const;
  Eigen::Vector3d probe_point() const;
  Cell divided(int part, int axes) const;
  DistanceQuery make_query(const RemainingSpace& space, const Eigen::Vector3d& point) const;
  void add_witness(const Witness& witness);
  bool find_nearby_balls(const RemainingSpace& space);
  void solve(const RemainingSpace& space, double enough);
  void limit_by(const Witness& ball, const RemainingSpace& space);

  Eigen::Vector3d center_;
  double half_size_;
  double bound_;
  Eigen::Vector3d measured_ = Eigen::Vector3d::Zero();  // the last centre that was measured, …
  double distance_ = 0.0;  // … of this cell or an ancestor, and its signed distance
  double value_ = 0.0;     // d_i at the centre, once measured
  /// Boundary points and balls outside that touch the boundary; once the centre is measured, the
  /// first is the boundary point closest to it.
  std::array<Witness, kept_witnesses> witnesses_;
  std::array<std::uint32_t, nearby_balls> nearby_{};
  Eigen::Vector3f peak_;  // where the witnesses together allow the most, relative to the half size
  std::uint32_t balls_seen_ = 0;  // the nearby ones are among the first so many balls
  std::uint8_t nearby_count_ = 0;
  bool is_solved_ = false;  // the bound rests on all witnesses together, not its parent's alone
  std::uint8_t witness_count_ = 0;
  std::uint8_t binding_ = 0;  // bit i is set if the bound rests on witness i
  std::uint8_t probes_ = 0;
  bool is_measured_ = false;
};

}  // namespace mdbd
