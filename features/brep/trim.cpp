#include "features/brep/trim.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdbd {
namespace {

using Eigen::Vector2d;

constexpr int bulge_samples = 8;
// A curve may bulge more between the samples.
constexpr double bulge_margin = 1.5;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

Trim::Trim(const BrepFace& face)
    : period_(face.period),
      lower_(Vector2d::Constant(std::numeric_limits<double>::infinity())),
      upper_(-lower_) {
  for (const OutlineSide& side : face.outline) add(side);
}

void Trim::add(const OutlineSide& side) {
  chords_.push_back({side.from, side.to});
  const auto extend = [&](const Vector2d& uv) {
    lower_ = lower_.cwiseMin(uv);
    upper_ = upper_.cwiseMax(uv);
  };
  extend(side.from);
  extend(side.to);
  const Vector2d chord = side.to - side.from;
  const double length = chord.norm();
  if (!side.curve || !(length > 0)) return;
  Arc arc{side.from, chord / length, length, 0.0, side.first, side.last, side.curve.get()};
  for (int i = 1; i < bulge_samples; ++i) {
    const double t = side.first + (side.last - side.first) * i / bulge_samples;
    const Vector2d uv = side.curve->at(t);
    extend(uv);
    arc.bulge = std::max(arc.bulge, bulge_margin * std::abs(cross(arc.along, uv - side.from)));
  }
  if (arc.bulge > 1e-12 * (length + side.from.norm())) arcs_.push_back(arc);
}

bool Trim::contains(const Vector2d& uv) const {
  Vector2d at = uv;
  for (int i = 0; i < 2; ++i) {
    if (period_[i] > 0) at[i] += period_[i] * std::ceil((lower_[i] - at[i]) / period_[i]);
  }
  bool is_inside = false;
  for (const auto& [from, to] : chords_) {
    if ((from.y() > at.y()) == (to.y() > at.y())) continue;
    const double share = (at.y() - from.y()) / (to.y() - from.y());
    if (at.x() < from.x() + share * (to.x() - from.x())) is_inside = !is_inside;
  }
  for (const Arc& arc : arcs_) {
    if (arc.separates(at)) is_inside = !is_inside;
  }
  return is_inside;
}

bool Trim::Arc::separates(const Vector2d& uv) const {
  const Vector2d offset = uv - from;
  const double height = cross(along, offset);
  if (std::abs(height) >= bulge) return false;
  const double place = along.dot(offset);
  if (place <= 0 || place >= length) return false;
  // The point of the curve above the same place of the chord.
  double low = first;
  double high = last;
  Vector2d on_curve;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    on_curve = curve->at(middle) - from;
    const double reached = along.dot(on_curve);
    if (std::abs(reached - place) <= 1e-14 * length) break;
    (reached < place ? low : high) = middle;
  }
  const double top = cross(along, on_curve);
  return top > 0 ? height > 0 && height < top : height < 0 && height > top;
}

}  // namespace mdbd
