#include "features/brep/bspline.h"

#include <algorithm>
#include <utility>

namespace mdbd {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr int max_degree = BsplineBasis::max_degree;

}  // namespace

BsplineBasis::BsplineBasis(int degree, std::vector<double> knots)
    : degree_(degree), knots_(std::move(knots)) {}

int BsplineBasis::find_span(double t) const {
  const auto begin = knots_.begin() + degree_;
  const auto end = knots_.end() - degree_ - 1;
  const auto after = std::upper_bound(begin + 1, end, t);
  return static_cast<int>(after - knots_.begin()) - 1;
}

void BsplineBasis::evaluate(double t, Values& values) const {
  const int p = degree_;
  const int span = find_span(t);
  // Functions in the upper triangle, differences of knots in the lower one.
  double table[max_degree + 1][max_degree + 1];
  double left[max_degree + 1];
  double right[max_degree + 1];
  table[0][0] = 1.0;
  for (int j = 1; j <= p; ++j) {
    left[j] = t - knots_[span + 1 - j];
    right[j] = knots_[span + j] - t;
    double saved = 0.0;
    for (int r = 0; r < j; ++r) {
      table[j][r] = right[r + 1] + left[j - r];
      const double share = table[r][j - 1] / table[j][r];
      table[r][j] = saved + right[r + 1] * share;
      saved = left[j - r] * share;
    }
    table[j][j] = saved;
  }
  values.first = span - p;
  const auto lower = [&](int r, int degree) {
    return r >= 0 && r <= degree ? table[r][degree] : 0.0;
  };
  // The derivative of function r of a degree, from those of one degree less.
  const auto differentiate = [&](int r, int degree, const auto& function) {
    double value = 0.0;
    if (r >= 1) value += function(r - 1) / table[degree][r - 1];
    if (r < degree) value -= function(r) / table[degree][r];
    return degree * value;
  };
  for (int r = 0; r <= p; ++r) {
    values.derivative[0][r] = table[r][p];
    values.derivative[1][r] = differentiate(r, p, [&](int s) { return lower(s, p - 1); });
    values.derivative[2][r] = p < 2 ? 0.0 : differentiate(r, p, [&](int s) {
      return differentiate(s, p - 1, [&](int q) { return lower(q, p - 2); });
    });
  }
}

BsplineSurface::BsplineSurface(BsplineBasis u, BsplineBasis v, std::vector<Vector4d> poles)
    : u_(std::move(u)), v_(std::move(v)), poles_(std::move(poles)) {}

SurfacePoint BsplineSurface::at(const Eigen::Vector2d& uv) const {
  BsplineBasis::Values u;
  BsplineBasis::Values v;
  u_.evaluate(uv.x(), u);
  v_.evaluate(uv.y(), v);
  // In homogeneous coordinates, [derivative by u][by v].
  Vector4d sum[3][3];
  for (auto& row : sum) std::ranges::fill(row, Vector4d::Zero());
  for (int i = 0; i <= u_.degree(); ++i) {
    const Vector4d* row = &poles_[(u.first + i) * v_.pole_count() + v.first];
    Vector4d along_v[3] = {Vector4d::Zero(), Vector4d::Zero(), Vector4d::Zero()};
    for (int j = 0; j <= v_.degree(); ++j) {
      for (int d = 0; d < 3; ++d) along_v[d] += v.derivative[d][j] * row[j];
    }
    for (int du = 0; du < 3; ++du) {
      for (int dv = 0; du + dv < 3; ++dv) sum[du][dv] += u.derivative[du][i] * along_v[dv];
    }
  }
  const auto point = [](const Vector4d& h) -> Vector3d { return h.head<3>(); };
  const double w = sum[0][0].w();
  SurfacePoint s;
  s.point = point(sum[0][0]) / w;
  s.du = (point(sum[1][0]) - sum[1][0].w() * s.point) / w;
  s.dv = (point(sum[0][1]) - sum[0][1].w() * s.point) / w;
  s.duu = (point(sum[2][0]) - 2.0 * sum[1][0].w() * s.du - sum[2][0].w() * s.point) / w;
  s.dvv = (point(sum[0][2]) - 2.0 * sum[0][1].w() * s.dv - sum[0][2].w() * s.point) / w;
  s.duv =
      (point(sum[1][1]) - sum[1][0].w() * s.dv - sum[0][1].w() * s.du - sum[1][1].w() * s.point) /
      w;
  return s;
}

BsplineCurve::BsplineCurve(BsplineBasis basis, std::vector<Vector4d> poles)
    : basis_(std::move(basis)), poles_(std::move(poles)) {}

CurvePoint BsplineCurve::at(double t) const {
  BsplineBasis::Values values;
  basis_.evaluate(t, values);
  Vector4d sum[3] = {Vector4d::Zero(), Vector4d::Zero(), Vector4d::Zero()};
  for (int i = 0; i <= basis_.degree(); ++i) {
    for (int d = 0; d < 3; ++d) sum[d] += values.derivative[d][i] * poles_[values.first + i];
  }
  const double w = sum[0].w();
  CurvePoint c;
  c.point = sum[0].head<3>() / w;
  c.first = (sum[1].head<3>() - sum[1].w() * c.point) / w;
  c.second = (sum[2].head<3>() - 2.0 * sum[1].w() * c.first - sum[2].w() * c.point) / w;
  return c;
}

}  // namespace mdbd
