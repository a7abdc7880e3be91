#include "features/brep/refine_tessellation.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "features/brep/deviation.h"

namespace mdbd {
namespace {

using Eigen::Vector3d;

// Each halves the sides, and so takes away three quarters of the deflection.
constexpr int max_rounds = 5;
constexpr std::size_t max_triangles = 500'000;

class Refinement {
 public:
  Refinement(Brep& brep, double deflection) : brep_(brep), deflection_(deflection) {}

  void run() {
    for (int round = 0; round < max_rounds && mesh().triangles.size() < max_triangles; ++round) {
      find_sides();
      choose_sides();
      if (!has_chosen_) return;
      divide();
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  struct Side {
    int triangles = 0;
    bool is_chosen = false;
    std::uint32_t middle = none;  // the vertex there, once it is made
  };

  TriangleMesh& mesh() { return brep_.mesh; }
  const BrepFace& face_of(std::size_t triangle) const {
    return brep_.faces[brep_.face_of[triangle]];
  }
  Side& side(std::uint32_t from, std::uint32_t to) { return sides_[std::minmax(from, to)]; }

  void find_sides() {
    sides_.clear();
    has_chosen_ = false;
    for (std::size_t t = 0; t < mesh().triangles.size(); ++t) {
      if (face_of(t).kind == SurfaceKind::plane) continue;
      const Triangle& corners = mesh().triangles[t];
      for (int i = 0; i < 3; ++i) ++side(corners[i], corners[(i + 1) % 3]).triangles;
    }
  }

  // A side is chosen if it is off, and the longest side of a triangle that is off inside.
  void choose_sides() {
    for (std::size_t t = 0; t < mesh().triangles.size(); ++t) {
      if (face_of(t).kind == SurfaceKind::plane) continue;
      const Triangle& corners = mesh().triangles[t];
      double longest = 0.0;
      Side* longest_side = nullptr;
      bool has_chosen_side = false;
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t from = corners[i];
        const std::uint32_t to = corners[(i + 1) % 3];
        Side& candidate = side(from, to);
        if (candidate.triangles != 2) continue;
        if (!candidate.is_chosen) candidate.is_chosen = is_off(t, middle_weight(i));
        has_chosen_side |= candidate.is_chosen;
        const double length = (mesh().vertices[from] - mesh().vertices[to]).squaredNorm();
        if (length > longest) {
          longest = length;
          longest_side = &candidate;
        }
      }
      if (!has_chosen_side && longest_side != nullptr && is_off(t, Vector3d::Constant(1.0 / 3.0))) {
        longest_side->is_chosen = has_chosen_side = true;
      }
      has_chosen_ |= has_chosen_side;
    }
  }

  bool is_off(std::size_t triangle, const Vector3d& weight) const {
    return measure_deviation(brep_, triangle, weight) > deflection_;
  }

  // The weights of the corners at the middle of a side.
  static Vector3d middle_weight(int side) {
    Vector3d weight = Vector3d::Constant(0.5);
    weight[(side + 2) % 3] = 0.0;
    return weight;
  }

  std::uint32_t middle_of(std::size_t triangle, const Triangle& corners, int number) {
    const std::uint32_t from = corners[number];
    const std::uint32_t to = corners[(number + 1) % 3];
    Side& divided = side(from, to);
    if (!divided.is_chosen || divided.middle != none) return divided.middle;
    const Eigen::Vector2d uv = 0.5 * (brep_.parameters[from] + brep_.parameters[to]);
    divided.middle = static_cast<std::uint32_t>(mesh().vertices.size());
    mesh().vertices.push_back(
        lift_to_surface(brep_, face_of(triangle), corners, middle_weight(number)));
    brep_.parameters.push_back(uv);
    return divided.middle;
  }

  void divide() {
    const std::vector<Triangle> triangles = std::exchange(mesh().triangles, {});
    const std::vector<std::uint32_t> faces = brep_.face_of;
    const auto chords = std::exchange(brep_.is_chord, {});
    std::vector<std::uint32_t> new_faces;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      divide(t, triangles[t], chords[t]);
      new_faces.resize(mesh().triangles.size(), faces[t]);
    }
    brep_.face_of = std::move(new_faces);
  }

  // The loop of corners and new vertices is cut into triangles: first the corners between two new
  // vertices, then what is left as a fan around a new vertex.
  void divide(std::size_t t, const Triangle& corners, const std::array<bool, 3>& chords) {
    std::array<std::uint32_t, 3> middle{none, none, none};
    if (face_of(t).kind != SurfaceKind::plane) {
      for (int i = 0; i < 3; ++i) middle[i] = middle_of(t, corners, i);
    }
    const auto count = 3 - std::ranges::count(middle, none);
    if (count == 0) return add(corners, chords);
    if (count == 3) {
      for (int i = 0; i < 3; ++i) {
        const int before = (i + 2) % 3;
        add({corners[i], middle[i], middle[before]}, {chords[i], false, chords[before]});
      }
      return add({middle[0], middle[1], middle[2]}, {false, false, false});
    }
    // Turned so that the first side is divided, and with two, the last is not.
    int first = 0;
    while (middle[first] == none || (count == 2 && middle[(first + 2) % 3] != none)) ++first;
    const int second = (first + 1) % 3;
    const int third = (first + 2) % 3;
    const std::uint32_t m = middle[first];
    add({corners[third], corners[first], m}, {chords[third], chords[first], false});
    if (count == 1) {
      return add({m, corners[second], corners[third]}, {chords[first], chords[second], false});
    }
    add({m, corners[second], middle[second]}, {chords[first], chords[second], false});
    add({m, middle[second], corners[third]}, {false, chords[second], false});
  }

  void add(const Triangle& corners, const std::array<bool, 3>& chords) {
    mesh().triangles.push_back(corners);
    brep_.is_chord.push_back(chords);
  }

  Brep& brep_;
  double deflection_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Side> sides_;
  bool has_chosen_ = false;
};

}  // namespace

void refine_tessellation(Brep& brep, double deflection) { Refinement(brep, deflection).run(); }

}  // namespace mdbd
