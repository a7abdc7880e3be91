#include "features/brep/exact_enclosing_ball.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>

#include "features/distance/enclosing_ball.h"

namespace mdbd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double precision = 1e-12;
// Points closer to each other than this, relative to the radius, are one: the ball of points that
// are almost the same is lost in rounding.
constexpr double least_distance = 1e-3;
constexpr int max_rounds = 100;
constexpr int max_idle_rounds = 5;  // that make the ball no smaller
constexpr int max_steps = 40;

// The step of Newton's method for half the squared distance from a centre; where that has no
// maximum nearby, a step uphill of the length of a triangle.
Vector2d ascent_step(const SurfacePoint& s, const Vector3d& offset, double length) {
  const Vector2d gradient(offset.dot(s.du), offset.dot(s.dv));
  Eigen::Matrix2d metric;
  metric << s.du.dot(s.du), s.du.dot(s.dv), s.du.dot(s.dv), s.dv.dot(s.dv);
  Eigen::Matrix2d hessian = metric;
  hessian(0, 0) += offset.dot(s.duu);
  hessian(0, 1) += offset.dot(s.duv);
  hessian(1, 0) += offset.dot(s.duv);
  hessian(1, 1) += offset.dot(s.dvv);
  if (hessian(0, 0) < 0 && hessian.determinant() > 0) return -hessian.inverse() * gradient;
  Vector2d uphill = gradient;
  if (metric.determinant() > 1e-12 * metric(0, 0) * metric(1, 1)) {
    uphill = metric.inverse() * gradient;
  }
  const double speed = (uphill.x() * s.du + uphill.y() * s.dv).norm();
  return speed > 0 ? Vector2d(uphill * (length / speed)) : Vector2d::Zero();
}

class Growth {
 public:
  Growth(const Brep& brep, std::span<const Trim> trims, const Deflections& deflections)
      : brep_(brep),
        trims_(trims),
        deflections_(deflections),
        node_count_(brep.mesh.vertices.size()),
        points_(brep.mesh.vertices) {}

  // Around any centre the farthest point makes a ball that encloses everything.
  Ball run() {
    Ball best{Vector3d::Zero(), std::numeric_limits<double>::infinity()};
    for (int round = 0, idle = 0; round < max_rounds && idle < max_idle_rounds; ++round, ++idle) {
      const Ball ball = enclosing_ball(points_);
      const double farthest = add_outside(ball);
      if (farthest < best.radius * (1 - precision)) idle = 0;
      if (farthest < best.radius) best = {ball.center, farthest};
      if (farthest <= ball.radius * (1 + precision)) break;
    }
    return best;
  }

 private:
  // Adds the local maxima outside a ball. Returns the largest distance from its centre.
  double add_outside(const Ball& ball) {
    double farthest = ball.radius;
    const auto consider = [&](const Vector3d& point) {
      const double distance = (point - ball.center).norm();
      if (distance > ball.radius * (1 + precision)) add(point, ball);
      farthest = std::max(farthest, distance);
    };
    for (std::size_t t = 0; t < brep_.mesh.triangles.size(); ++t) {
      if (!brep_.faces[brep_.face_of[t]].is_polygon && may_stick_out(t, ball)) {
        climb(t, ball.center, consider);
      }
    }
    for (std::size_t e = 0; e < brep_.edges.size(); ++e) {
      const BrepEdge& edge = brep_.edges[e];
      if (edge.kind != CurveKind::line) climb(edge, deflections_.edges[e], ball, consider);
    }
    return farthest;
  }

  // In place of an earlier point of the same bulge.
  void add(const Vector3d& point, const Ball& ball) {
    const double squared = least_distance * least_distance * ball.radius * ball.radius;
    const auto same = std::find_if(
        points_.begin() + static_cast<std::ptrdiff_t>(node_count_), points_.end(),
        [&](const Vector3d& known) { return (known - point).squaredNorm() < squared; });
    if (same == points_.end()) {
      points_.push_back(point);
    } else if ((*same - ball.center).squaredNorm() < (point - ball.center).squaredNorm()) {
      *same = point;
    }
  }

  bool may_stick_out(std::size_t triangle, const Ball& ball) const {
    return std::ranges::any_of(brep_.mesh.triangles[triangle], [&](std::uint32_t corner) {
      return (brep_.mesh.vertices[corner] - ball.center).norm() + deflections_.triangles[triangle] >
             ball.radius;
    });
  }

  template <typename Visitor>
  void climb(std::size_t triangle, const Vector3d& center, const Visitor& consider) const {
    const auto& [a, b, c] = brep_.mesh.triangles[triangle];
    const BrepFace& face = brep_.faces[brep_.face_of[triangle]];
    const Trim& trim = trims_[brep_.face_of[triangle]];
    const double length = (brep_.mesh.vertices[b] - brep_.mesh.vertices[a]).norm();
    Vector2d uv = (brep_.parameters[a] + brep_.parameters[b] + brep_.parameters[c]) / 3.0;
    const Surroundings surroundings(brep_.parameters[a], brep_.parameters[b], brep_.parameters[c],
                                    face, trim);
    SurfacePoint s = face.surface->at(uv);
    for (int i = 0; i < max_steps; ++i) {
      const Vector3d offset = s.point - center;
      Vector2d step = ascent_step(s, offset, length);
      Vector2d next = uv + step;
      SurfacePoint at_next = s;
      for (int halvings = 0; halvings < 10; ++halvings) {
        next = surroundings.limit(uv + step);
        at_next = face.surface->at(next);
        if ((at_next.point - center).squaredNorm() > offset.squaredNorm()) break;
        step *= 0.5;
      }
      const double gain = (at_next.point - center).squaredNorm() - offset.squaredNorm();
      if (!(gain > 0)) break;
      uv = next;
      s = at_next;
      if (gain <= 0.01 * precision * offset.squaredNorm()) break;
    }
    if (trim.contains(uv)) consider(s.point);
  }

  // The parameters of a triangle and a margin around them: from beyond other triangles climb.
  struct Surroundings {
    Vector2d lower;
    Vector2d upper;

    Surroundings(const Vector2d& a, const Vector2d& b, const Vector2d& c, const BrepFace& face,
                 const Trim& trim)
        : lower(a.cwiseMin(b).cwiseMin(c)), upper(a.cwiseMax(b).cwiseMax(c)) {
      const Vector2d margin = 0.5 * (upper - lower);
      lower -= margin;
      upper += margin;
      for (int i = 0; i < 2; ++i) {
        if (face.period[i] > 0) continue;
        lower[i] = std::max(lower[i], trim.lower()[i]);
        upper[i] = std::min(upper[i], trim.upper()[i]);
      }
    }
    Vector2d limit(const Vector2d& uv) const { return uv.cwiseMax(lower).cwiseMin(upper); }
  };

  // The largest distance between two nodes by ternary search, to half the digits, which is all that
  // a maximum needs.
  template <typename Visitor>
  void climb(const BrepEdge& edge, double deflection, const Ball& ball,
             const Visitor& consider) const {
    const auto distance = [&](double t) { return (edge.curve->at(t).point - ball.center).norm(); };
    for (std::size_t i = 0; i + 1 < edge.parameters.size(); ++i) {
      double low = edge.parameters[i];
      double high = edge.parameters[i + 1];
      if (std::max(distance(low), distance(high)) + deflection <= ball.radius) continue;
      for (int step = 0; step < 60; ++step) {
        const double left = low + (high - low) / 3.0;
        const double right = high - (high - low) / 3.0;
        (distance(left) < distance(right) ? low : high) =
            distance(left) < distance(right) ? left : right;
      }
      consider(edge.curve->at(low).point);
    }
  }

  const Brep& brep_;
  std::span<const Trim> trims_;
  const Deflections& deflections_;
  std::size_t node_count_;
  std::vector<Vector3d> points_;  ///< the nodes, then those that were added
};

}  // namespace

Ball exact_enclosing_ball(const Brep& brep, std::span<const Trim> trims,
                          const Deflections& deflections) {
  return Growth(brep, trims, deflections).run();
}

}  // namespace mdbd
