#include "evaluation/certificate/rival_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/core/box.h"

namespace mdbd {
namespace {

// A climb begins with steps of this size, relative to the radius, and adapts it so that about one
// trial in five succeeds: the rule of evolution strategies (Rechenberg 1973).
constexpr double first_step = 0.5;
constexpr double growth = 1.6;
constexpr double decay = 0.88;

// The nearest starting point to the surface, relative to the largest ball.
constexpr double smallest_depth = 1e-3;

}  // namespace

RivalSearch::RivalSearch(const MeshMeasure& measure, double largest, const RecheckOptions& options)
    : measure_(measure), options_(options), random_(options.seed) {
  const int in_box = options.samples / 2;
  std::vector<Eigen::Vector3d> points = points_in_box(in_box);
  for (const Eigen::Vector3d& point : points_near_surface(options.samples - in_box, largest)) {
    points.push_back(point);
  }
  for (const Eigen::Vector3d& point : points) {
    if (measure_.is_inside(point)) sites_.push_back(this->measure(point));
  }
}

Eigen::Vector3d RivalSearch::random_direction() {
  while (true) {  // uniform in the unit ball, without its middle
    const double x = random_.uniform(-1, 1);
    const double y = random_.uniform(-1, 1);
    const double z = random_.uniform(-1, 1);
    const Eigen::Vector3d direction(x, y, z);
    const double length = direction.norm();
    if (length <= 1 && length > 0.1) return direction / length;
  }
}

std::vector<Eigen::Vector3d> RivalSearch::points_in_box(int count) {
  Box box;
  for (const Eigen::Vector3d& vertex : measure_.mesh().vertices) box.extend(vertex);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = random_.uniform(box.min()[axis], box.max()[axis]);
    }
    points.push_back(point);
  }
  return points;
}

std::vector<Eigen::Vector3d> RivalSearch::points_near_surface(int count, double largest) {
  const TriangleMesh& mesh = measure_.mesh();
  std::vector<double> areas;  // of all triangles up to this one, doubled
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d ab = mesh.vertices[b] - mesh.vertices[a];
    sum += ab.cross(mesh.vertices[c] - mesh.vertices[a]).norm();
    areas.push_back(sum);
  }
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const auto found = std::ranges::upper_bound(areas, random_.uniform(0, sum));
    const std::size_t number = std::min<std::size_t>(found - areas.begin(), areas.size() - 1);
    const auto& [a, b, c] = mesh.triangles[number];
    const Eigen::Vector3d ab = mesh.vertices[b] - mesh.vertices[a];
    const Eigen::Vector3d ac = mesh.vertices[c] - mesh.vertices[a];
    double u = random_.uniform();
    double v = random_.uniform();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const double depth = largest * std::pow(smallest_depth, random_.uniform());
    const Eigen::Vector3d outward = ab.cross(ac).stableNormalized();
    points.push_back(mesh.vertices[a] + u * ab + v * ac - depth * outward);
  }
  return points;
}

/// The distance from the placed balls, or some distance of at most `enough`.
double RivalSearch::gap(const Eigen::Vector3d& point, double enough) const {
  double gap = std::numeric_limits<double>::infinity();
  for (const Ball& ball : placed_) {
    gap = std::min(gap, (point - ball.center).norm() - ball.radius);
    if (gap <= enough) break;
  }
  return gap;
}

RivalSearch::Site RivalSearch::measure(const Eigen::Vector3d& point) const {
  return {point, std::min(measure_.distance(point), gap(point, 0.0))};
}

/// Tries places at random and moves to those of larger balls. Steps are shorter than the radius of
/// a ball that the surface does not cut, so that the climb stays inside.
RivalSearch::Site RivalSearch::climb(Site site) {
  double step = first_step;
  for (int trial = 0; trial < options_.climb_trials && site.radius > 0; ++trial) {
    const Eigen::Vector3d point = site.point + step * site.radius * random_direction();
    if (gap(point, site.radius) > site.radius && measure_.is_clear(point, site.radius)) {
      site = measure(point);
      step = std::min(first_step, step * growth);
    } else {
      step *= decay;
    }
  }
  site.climbed_radius = site.radius;
  return site;
}

Ball RivalSearch::find() {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < sites_.size(); ++i) {
    if (sites_[i].radius != sites_[i].climbed_radius) starts.push_back(i);
  }
  const std::size_t climbs = std::min<std::size_t>(options_.climbs, starts.size());
  std::ranges::partial_sort(
      starts, starts.begin() + static_cast<std::ptrdiff_t>(climbs),
      [&](std::size_t a, std::size_t b) { return sites_[a].radius > sites_[b].radius; });
  for (std::size_t i = 0; i < climbs; ++i) {
    sites_[starts[i]].climbed_radius = sites_[starts[i]].radius;
    sites_.push_back(climb(sites_[starts[i]]));
  }
  const auto best = std::ranges::max_element(sites_, {}, &Site::radius);
  return best == sites_.end() ? Ball{} : Ball{best->point, best->radius};
}

Ball RivalSearch::find_near(const Eigen::Vector3d& point) {
  const Site site = climb(measure(point));
  return {site.point, site.radius};
}

void RivalSearch::place(const Ball& ball) {
  placed_.push_back(ball);
  for (Site& site : sites_) {
    site.radius = std::min(site.radius, (site.point - ball.center).norm() - ball.radius);
  }
  std::erase_if(sites_, [](const Site& site) { return site.radius <= 0; });
  for (int i = 0; i < options_.samples_per_ball; ++i) {
    const Eigen::Vector3d direction = random_direction();
    const Eigen::Vector3d touching = ball.center + ball.radius * direction;
    const Site site = measure(touching + 0.5 * measure_.distance(touching) * direction);
    if (site.radius > 0) sites_.push_back(site);
  }
}

}  // namespace mdbd
