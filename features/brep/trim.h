#pragma once

#include <vector>

#include "features/brep/brep.h"

namespace mdbd {

/// Which parameters of a surface belong to a face. Thread-safe.
class Trim {
 public:
  explicit Trim(const BrepFace& face);

  /// The smallest box that holds the outline.
  const Eigen::Vector2d& lower() const { return lower_; }
  const Eigen::Vector2d& upper() const { return upper_; }

  /// Whether the parameters belong to the face, after a shift by whole periods.
  bool contains(const Eigen::Vector2d& uv) const;

 private:
  /// A side that bulges beyond its chord.
  struct Arc {
    Eigen::Vector2d from;
    Eigen::Vector2d along;  ///< unit vector
    double length;
    double bulge;  ///< at most so far from the chord
    double first;  ///< parameters of the curve
    double last;
    const ParameterCurve* curve;

    /// Whether a point is between chord and curve.
    bool separates(const Eigen::Vector2d& uv) const;
  };
  struct Chord {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
  };

  void add(const OutlineSide& side);

  Eigen::Vector2d period_;
  Eigen::Vector2d lower_;
  Eigen::Vector2d upper_;
  std::vector<Chord> chords_;
  std::vector<Arc> arcs_;
};

}  // namespace mdbd
