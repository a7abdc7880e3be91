#include "features/brep/bspline.h"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

using namespace mdbd;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {

/// A quarter of the unit circle as a rational spline of degree 2.
BsplineCurve quarter_circle() {
  const double w = std::sqrt(0.5);
  return {BsplineBasis(2, {0, 0, 0, 1, 1, 1}),
          {Vector4d(1, 0, 0, 1), Vector4d(w, w, 0, w), Vector4d(0, 1, 0, 1)}};
}

}  // namespace

TEST_CASE("a rational spline is a circle, and its derivatives are those of differences") {
  const BsplineCurve circle = quarter_circle();
  const double h = 1e-5;
  for (const double t : {0.1, 0.5, 0.83}) {
    const CurvePoint at = circle.at(t);
    CHECK(at.point.norm() == Approx(1.0).epsilon(1e-14));
    const Vector3d before = circle.at(t - h).point;
    const Vector3d after = circle.at(t + h).point;
    CHECK((at.first - (after - before) / (2 * h)).norm() < 1e-8);
    CHECK((at.second - (after - 2 * at.point + before) / (h * h)).norm() < 1e-4);
  }
}

TEST_CASE("basis functions sum to one, across knots of any multiplicity") {
  const BsplineBasis basis(3, {0, 0, 0, 0, 1, 2, 2, 3, 4, 4, 4, 4});
  for (const double t : {0.0, 0.5, 1.0, 1.99, 2.0, 3.5, 4.0}) {
    BsplineBasis::Values values;
    basis.evaluate(t, values);
    double sums[3] = {};
    for (int d = 0; d < 3; ++d) {
      for (int i = 0; i <= 3; ++i) sums[d] += values.derivative[d][i];
    }
    CHECK(values.first >= 0);
    CHECK(values.first + 3 < basis.pole_count());
    CHECK(sums[0] == Approx(1.0));
    CHECK(sums[1] == Approx(0.0).margin(1e-12));
    CHECK(sums[2] == Approx(0.0).margin(1e-12));
  }
}

TEST_CASE("a spline surface has the derivatives of differences") {
  // A quarter of a cylinder that leans.
  const double w = std::sqrt(0.5);
  std::vector<Vector4d> poles;
  for (const double z : {0.0, 1.0, 3.0}) {
    for (const Vector4d& pole :
         {Vector4d(1, 0, z, 1), Vector4d(w, w, w * z, w), Vector4d(z, 1, 0, 1)}) {
      poles.push_back(pole);
    }
  }
  const BsplineSurface surface(BsplineBasis(2, {0, 0, 0, 1, 1, 1}),
                               BsplineBasis(2, {0, 0, 0, 1, 1, 1}), poles);
  const double h = 1e-5;
  const auto point = [&](double u, double v) { return surface.at({u, v}).point; };
  for (const double u : {0.2, 0.7}) {
    for (const double v : {0.3, 0.9}) {
      const SurfacePoint s = surface.at({u, v});
      CHECK((s.du - (point(u + h, v) - point(u - h, v)) / (2 * h)).norm() < 1e-8);
      CHECK((s.dv - (point(u, v + h) - point(u, v - h)) / (2 * h)).norm() < 1e-8);
      CHECK((s.duu - (point(u + h, v) - 2 * s.point + point(u - h, v)) / (h * h)).norm() < 1e-4);
      CHECK((s.dvv - (point(u, v + h) - 2 * s.point + point(u, v - h)) / (h * h)).norm() < 1e-4);
      const Vector3d mixed =
          point(u + h, v + h) - point(u + h, v - h) - point(u - h, v + h) + point(u - h, v - h);
      CHECK((s.duv - mixed / (4 * h * h)).norm() < 1e-4);
    }
  }
}
