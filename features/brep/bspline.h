#pragma once

#include <vector>

#include <Eigen/Core>

#include "features/brep/geometry.h"

namespace mdbd {

/// The knots of B-splines in one parameter, with their basis functions (Piegl and Tiller, The NURBS
/// Book, algorithms A2.1 to A2.3).
class BsplineBasis {
 public:
  static constexpr int max_degree = 25;

  /// The basis functions that do not vanish at a parameter, with their first two derivatives.
  struct Values {
    int first;  ///< the number of the pole that belongs to the first of them
    double derivative[3][max_degree + 1];
  };

  /// @param knots each as often as its multiplicity, in increasing order
  /// @pre 0 < degree <= max_degree, knots.size() >= 2 (degree + 1)
  BsplineBasis(int degree, std::vector<double> knots);

  int degree() const { return degree_; }
  int pole_count() const { return static_cast<int>(knots_.size()) - degree_ - 1; }
  /// Beyond the ends the outer polynomials go on.
  void evaluate(double t, Values& values) const;

 private:
  int find_span(double t) const;

  int degree_;
  std::vector<double> knots_;
};

/// A surface of B-splines, rational or not, evaluated without the caches of OpenCASCADE's, which
/// are for one thread, and faster than without them.
class BsplineSurface final : public ParametricSurface {
 public:
  /// @param poles in homogeneous coordinates (weight times point, weight), v fastest
  BsplineSurface(BsplineBasis u, BsplineBasis v, std::vector<Eigen::Vector4d> poles);
  SurfacePoint at(const Eigen::Vector2d& uv) const override;

 private:
  BsplineBasis u_;
  BsplineBasis v_;
  std::vector<Eigen::Vector4d> poles_;
};

/// A curve of B-splines, rational or not.
class BsplineCurve final : public ParametricCurve {
 public:
  /// @param poles in homogeneous coordinates
  BsplineCurve(BsplineBasis basis, std::vector<Eigen::Vector4d> poles);
  CurvePoint at(double t) const override;

 private:
  BsplineBasis basis_;
  std::vector<Eigen::Vector4d> poles_;
};

}  // namespace mdbd
