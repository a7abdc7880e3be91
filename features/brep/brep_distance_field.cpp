#include "features/brep/brep_distance_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "features/brep/closest_on_edge.h"
#include "features/brep/closest_on_surface.h"
#include "features/brep/deviation.h"
#include "features/brep/exact_enclosing_ball.h"
#include "features/core/errors.h"
#include "features/core/triangle.h"

namespace mdbd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// The deflection is measured at samples; between them it may be so much larger.
constexpr double deflection_margin = 1.5;
// What rounding makes of a distance, relative to the size of the shape.
constexpr double rounding = 1e-12;
// The walk to a side that is certain doubles the distance in each step.
constexpr int max_walk_steps = 60;

// Barycentric coordinates of a point of a triangle; those of a corner if it has no area.
Vector3d barycentric(const TriangleCorners& corners, const Vector3d& point) {
  const Vector3d ab = corners[1] - corners[0];
  const Vector3d ac = corners[2] - corners[0];
  const Vector3d ap = point - corners[0];
  const Vector3d normal = ab.cross(ac);
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return {1.0, 0.0, 0.0};
  const double b = std::clamp(ap.cross(ac).dot(normal) / squared, 0.0, 1.0);
  const double c = std::clamp(ab.cross(ap).dot(normal) / squared, 0.0, 1.0 - b);
  return {1.0 - b - c, b, c};
}

double measure_triangle(const Brep& brep, std::size_t triangle) {
  static const Vector3d samples[] = {{1.0, 0.0, 0.0},          {0.0, 1.0, 0.0},
                                     {0.0, 0.0, 1.0},          {0.5, 0.5, 0.0},
                                     {0.0, 0.5, 0.5},          {0.5, 0.0, 0.5},
                                     {1 / 3., 1 / 3., 1 / 3.}, {2 / 3., 1 / 6., 1 / 6.},
                                     {1 / 6., 2 / 3., 1 / 6.}, {1 / 6., 1 / 6., 2 / 3.}};
  double largest = 0.0;
  for (const Vector3d& weight : samples) {
    largest = std::max(largest, measure_deviation(brep, triangle, weight));
  }
  return largest;
}

double measure_edge(const BrepEdge& edge) {
  if (edge.kind == CurveKind::line) return 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < edge.parameters.size(); ++i) {
    const double first = edge.parameters[i];
    const double last = edge.parameters[i + 1];
    const Vector3d from = edge.curve->at(first).point;
    const Vector3d to = edge.curve->at(last).point;
    for (const double share : {0.25, 0.5, 0.75}) {
      const Vector3d point = edge.curve->at(first + share * (last - first)).point;
      largest = std::max(largest, (closest_point_of_segment(from, to, point) - point).norm());
    }
  }
  return largest;
}

}  // namespace

BrepDistanceField::BrepDistanceField(Brep brep) : brep_(std::move(brep)) {
  if (brep_.mesh.triangles.empty()) throw InvalidInput("the shape has no faces");
  for (const BrepFace& face : brep_.faces) trims_.emplace_back(face);
  measure_deflection();
  enclosing_ball_ = exact_enclosing_ball(brep_, trims_, deflections_);
  if (!(enclosing_ball_.radius > 0)) throw InvalidInput("all points of the shape coincide");
  deflection_ += rounding * enclosing_ball_.radius;
  faces_ = std::make_unique<TriangleTree>(brep_.mesh);
  elements_ = std::make_unique<TriangleTree>(collect_elements());
  winding_number_ = std::make_unique<WindingNumber>(*faces_);
  const double edges =
      deflections_.edges.empty() ? 0.0 : *std::ranges::max_element(deflections_.edges);
  flat_faces_ = std::make_unique<FlatFaces>(brep_, edges + rounding * enclosing_ball_.radius);
}

// Beside a curved edge a face may end before its triangles or behind them.
void BrepDistanceField::measure_deflection() {
  double of_edges = 0.0;
  for (const BrepEdge& edge : brep_.edges) {
    deflections_.edges.push_back(deflection_margin * measure_edge(edge));
    of_edges = std::max(of_edges, deflections_.edges.back());
  }
  deflection_ = of_edges;
  for (std::size_t t = 0; t < brep_.mesh.triangles.size(); ++t) {
    const BrepFace& face = brep_.faces[brep_.face_of[t]];
    double& deflection = deflections_.triangles.emplace_back(0.0);
    if (face.is_polygon) continue;
    deflection = deflection_margin * measure_triangle(brep_, t);
    if (std::ranges::count(brep_.is_chord[t], true) > 0) deflection += of_edges;
    deflection_ = std::max(deflection_, deflection);
  }
}

TriangleMesh BrepDistanceField::collect_elements() {
  TriangleMesh mesh = brep_.mesh;
  for (std::uint32_t e = 0; e < brep_.edges.size(); ++e) {
    const BrepEdge& edge = brep_.edges[e];
    for (std::uint32_t i = 0; i + 1 < edge.parameters.size(); ++i) {
      const Vector3d from = edge.curve->at(edge.parameters[i]).point;
      const Vector3d to = edge.curve->at(edge.parameters[i + 1]).point;
      if (from == to) continue;
      const auto vertex = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.insert(mesh.vertices.end(), {from, to});
      mesh.triangles.push_back({vertex, vertex + 1, vertex + 1});
      segments_.push_back({e, i});
    }
  }
  return mesh;
}

/// One search for the closest point of the boundary.
class BrepDistanceField::Search {
 public:
  Search(const BrepDistanceField& field, const Vector3d& point, double bound)
      : field_(field), point_(point), brep_(field.brep_) {
    thread_local std::vector<ClosestPoint> found;
    find_near_triangles(*field.elements_, point, 2.0 * field.deflection_, bound + field.deflection_,
                        found);
    // Surfaces and tessellation are no farther from each other than the deflection, so what seems
    // to be nearer is beyond a face after all.
    least_ = std::sqrt(found.front().squared_distance) - field.deflection_;
    for (const ClosestPoint& candidate : found) consider(candidate);
    if (best_.squared_distance < std::numeric_limits<double>::infinity()) return;
    const ClosestPoint& closest = found.front();
    const std::uint32_t element = field.elements_->sources()[closest.triangle];
    offer(closest.point, element,
          field.is_segment(element) ? Vector2d(Vector2d::Zero()) : start(closest, element));
  }

  const Nearest& best() const { return best_; }

 private:
  /// A strict minimum of the distance from a surface that has no closed form.
  struct Foot {
    std::uint32_t face;
    Vector3d point;
  };

  void consider(const ClosestPoint& candidate) {
    const std::uint32_t element = field_.elements_->sources()[candidate.triangle];
    const double distance = std::sqrt(candidate.squared_distance);
    if (field_.is_segment(element)) {
      const auto& [edge, number] = field_.segments_[element - brep_.mesh.triangles.size()];
      if (distance - field_.deflections_.edges[edge] > best_distance_) return;
      consider_edge(candidate, element, edge, number);
    } else {
      const std::uint32_t face = brep_.face_of[element];
      if (distance - field_.deflections_.triangles[element] > best_distance_) return;
      consider_face(candidate, element, face);
    }
  }

  void consider_edge(const ClosestPoint& candidate, std::uint32_t element, std::uint32_t number,
                     std::uint32_t segment) {
    const BrepEdge& edge = brep_.edges[number];
    if (edge.kind == CurveKind::line) return offer(candidate.point, element);
    if (edge.kind == CurveKind::circle && !is_new(number | edge_mark)) return;
    offer(closest_point(edge, segment, point_), element);
  }

  void consider_face(const ClosestPoint& candidate, std::uint32_t element, std::uint32_t number) {
    const BrepFace& face = brep_.faces[number];
    if (face.is_polygon) return offer(candidate.point, element, start(candidate, element));
    if (face.kind != SurfaceKind::other && !is_new(number)) return;
    if (is_known(candidate, number)) return;
    const Trim& trim = field_.trims_[number];
    const auto foot =
        find_foot(face, point_, start(candidate, element), trim.lower(), trim.upper());
    if (foot && foot->is_isolated) remember({number, foot->point});
    if (!foot || (foot->point - point_).norm() < least_) return;
    if ((foot->point - point_).squaredNorm() >= best_.squared_distance) return;
    if (trim.contains(foot->uv)) offer(foot->point, element, foot->uv);
  }

  // Whether the foot that a triangle leads to was found from a neighbour.
  bool is_known(const ClosestPoint& candidate, std::uint32_t face) const {
    const auto& [a, b, c] = field_.elements_->triangles()[candidate.triangle];
    const double squared_size =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return std::any_of(feet_.begin(), feet_.begin() + static_cast<std::ptrdiff_t>(foot_count_),
                       [&](const Foot& foot) {
                         return foot.face == face &&
                                (foot.point - candidate.point).squaredNorm() < squared_size;
                       });
  }

  void remember(const Foot& foot) {
    if (foot_count_ < feet_.size()) feet_[foot_count_++] = foot;
  }

  // The parameters of the point of a triangle.
  Vector2d start(const ClosestPoint& candidate, std::uint32_t element) const {
    const Triangle& corners = brep_.mesh.triangles[element];
    const Vector3d weight =
        barycentric(field_.elements_->triangles()[candidate.triangle], candidate.point);
    return weight[0] * brep_.parameters[corners[0]] + weight[1] * brep_.parameters[corners[1]] +
           weight[2] * brep_.parameters[corners[2]];
  }

  void offer(const Vector3d& point, std::uint32_t element, const Vector2d& uv = Vector2d::Zero()) {
    const double squared = (point - point_).squaredNorm();
    if (!(squared < best_.squared_distance)) return;
    best_ = {point, squared, element, uv};
    best_distance_ = std::sqrt(squared);
  }

  // Whether a face or edge has not been looked at; it counts as looked at then.
  bool is_new(std::uint32_t mark) {
    const auto end = seen_.begin() + static_cast<std::ptrdiff_t>(std::min(count_, seen_.size()));
    if (std::find(seen_.begin(), end, mark) != end) return false;
    seen_[count_++ % seen_.size()] = mark;
    return true;
  }

  static constexpr std::uint32_t edge_mark = 0x80000000;

  const BrepDistanceField& field_;
  Vector3d point_;
  const Brep& brep_;
  double least_ = 0.0;
  double best_distance_ = std::numeric_limits<double>::infinity();
  Nearest best_{Vector3d::Zero(), std::numeric_limits<double>::infinity(), 0, Vector2d::Zero()};
  std::array<std::uint32_t, 16> seen_;
  std::size_t count_ = 0;
  std::array<Foot, 16> feet_;
  std::size_t foot_count_ = 0;
};

void BrepDistanceField::measure(std::span<const DistanceQuery> queries,
                                std::span<DistanceSample> samples) const {
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const DistanceQuery& query = queries[i];
    const Nearest nearest = Search(*this, query.point, query.bound).best();
    const double distance = std::sqrt(nearest.squared_distance);
    // The neighbour is not asked: where the search on a curved surface ends at another point than
    // the closest, the ball up to it is not empty; and the side costs little beside the search.
    const bool inside =
        query.side == Side::unknown ? is_inside(query.point, nearest) : query.side == Side::inside;
    samples[i] = {inside ? distance : -distance, nearest.point};
    if (is_segment(nearest.element)) continue;
    samples[i].piece = flat_faces_->piece_of(nearest.element);
    samples[i].flat_region = flat_faces_->around(nearest.point, nearest.element);
  }
}

// The ball around a point up to the boundary is on one side. From ball to ball, away from the
// boundary, the walk comes to where the tessellation tells the sides apart.
bool BrepDistanceField::is_inside(const Vector3d& point, const Nearest& nearest) const {
  constexpr double stride = 1.9;
  constexpr double least_growth = 1.05;
  Vector3d at = point;
  Nearest last = nearest;
  for (int i = 0; i < max_walk_steps; ++i) {
    const double distance = std::sqrt(last.squared_distance);
    if (distance > deflection_ || !(distance > 0)) break;
    const Vector3d next = last.point + stride * (at - last.point);
    const Nearest there = Search(*this, next, stride * distance).best();
    if (there.squared_distance < least_growth * least_growth * last.squared_distance) {
      if (is_segment(last.element)) break;
      return is_behind_face(at, last);  // in a gap or wall that is thinner than the deflection
    }
    at = next;
    last = there;
  }
  return (*winding_number_)(at) > 0.5;
}

bool BrepDistanceField::is_behind_face(const Vector3d& point, const Nearest& nearest) const {
  const BrepFace& face = brep_.faces[brep_.face_of[nearest.element]];
  const SurfacePoint s = face.surface->at(nearest.uv);
  const double height = (point - nearest.point).dot(s.du.cross(s.dv));
  return face.is_reversed ? height > 0 : height < 0;
}

}  // namespace mdbd
