#include "features/implicit/read_csg.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "features/core/errors.h"

namespace mdbd {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;
using nlohmann::json;

constexpr int most_nested = 64;
constexpr int most_primitives = 2000;
constexpr double largest_number = 1e15;

/// A value of the document and where it stands.
struct Place {
  const json& value;
  std::string path;

  [[noreturn]] void refuse(const std::string& reason) const {
    throw InvalidInput((path.empty() ? "/" : path) + ": " + reason);
  }
  Place at(const std::string& key) const {
    if (!value.is_object()) refuse("must be an object");
    const auto found = value.find(key);
    if (found == value.end()) refuse("has no \"" + key + "\"");
    return {*found, path + "/" + key};
  }
  Place at(std::size_t index) const { return {value[index], fmt::format("{}/{}", path, index)}; }
};

// Nothing is overlooked: a misspelt key is a mistake.
void allow_keys(const Place& place, std::initializer_list<std::string_view> known) {
  if (!place.value.is_object()) place.refuse("must be an object");
  for (const auto& [key, value] : place.value.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    place.refuse(fmt::format("\"{:.40}\" is not known here", key));
  }
}

double read_number(const Place& place) {
  if (!place.value.is_number()) place.refuse("must be a number");
  const auto number = place.value.get<double>();
  if (!(std::abs(number) <= largest_number)) place.refuse("must be between -1e15 and 1e15");
  return number;
}

double read_length(const Place& place) {
  const double length = read_number(place);
  if (!(length >= 1.0 / largest_number)) place.refuse("must be above 0");
  return length;
}

Vector3d read_vector(const Place& place) {
  if (!place.value.is_array() || place.value.size() != 3) {
    place.refuse("must be an array of three numbers");
  }
  return {read_number(place.at(0)), read_number(place.at(1)), read_number(place.at(2))};
}

Vector3d read_direction(const Place& place) {
  const Vector3d direction = read_vector(place);
  if (!(direction.norm() >= 1.0 / largest_number)) place.refuse("must not be zero");
  return direction.stableNormalized();
}

Vector3d read_center(const Place& place) {
  return place.value.contains("center") ? read_vector(place.at("center")) : Vector3d::Zero();
}

/// What is done to a node: first scaled, then turned, then moved.
struct Placement {
  double scale = 1.0;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vector3d translation = Vector3d::Zero();

  Vector3d point(const Vector3d& x) const { return scale * (rotation * x) + translation; }
  Vector3d direction(const Vector3d& x) const { return rotation * x; }
  /// This after another.
  Placement after(const Placement& other) const {
    return {scale * other.scale, rotation * other.rotation, point(other.translation)};
  }
};

AlignedBox3d box_around(const Vector3d& center, const Vector3d& reach) {
  return {center - reach, center + reach};
}

/// How far a disc reaches along the axes of space.
Vector3d disc_reach(const Vector3d& axis, double radius) {
  return radius * (1.0 - axis.array().square()).max(0.0).sqrt();
}

/// Builds the solid from the nodes of a document.
class CsgReader {
 public:
  CsgSolid read(const Place& node) && {
    read_node(node, {}, true, 0);
    return std::move(builder_).finish();
  }

 private:
  /// @param is_inside whether the node is meant or its complement
  void read_node(const Place& node, const Placement& placement, bool is_inside, int depth) {
    if (depth > most_nested) node.refuse(fmt::format("is nested deeper than {}", most_nested));
    if (!node.value.is_object() || node.value.empty()) {
      node.refuse("must be an object that names a solid");
    }
    const std::string& kind = kind_of(node);
    const Place content = node.at(kind);
    if (kind == "union" || kind == "intersection" || kind == "difference") {
      read_operation(kind, content, placement, is_inside, depth);
    } else if (kind == "translate" || kind == "rotate" || kind == "scale") {
      allow_keys(node, {kind, "of"});
      read_node(node.at("of"), placement.after(read_placement(kind, content)), is_inside,
                depth + 1);
    } else {
      if (++primitives_ > most_primitives) {
        node.refuse(fmt::format("is one primitive more than {}", most_primitives));
      }
      read_primitive(kind, content, placement, is_inside);
    }
  }

  static const std::string& kind_of(const Place& node) {
    const std::string* kind = nullptr;
    for (const auto& [key, value] : node.value.items()) {
      if (key == "of") continue;
      if (kind != nullptr) {
        node.refuse(fmt::format("names two solids, \"{:.40}\" and \"{:.40}\"", *kind, key));
      }
      kind = &key;
    }
    if (kind == nullptr) node.refuse("must be an object that names a solid");
    return node.value.find(*kind).key();
  }

  void read_operation(const std::string& kind, const Place& parts, const Placement& placement,
                      bool is_inside, int depth) {
    if (!parts.value.is_array() || parts.value.empty()) {
      parts.refuse("must be an array of at least one solid");
    }
    for (std::size_t i = 0; i < parts.value.size(); ++i) {
      const bool is_taken_away = kind == "difference" && i > 0;
      read_node(parts.at(i), placement, is_inside != is_taken_away, depth + 1);
    }
    // The complement of a union is the intersection of complements.
    if ((kind == "union") == is_inside) {
      builder_.unite(parts.value.size());
    } else {
      builder_.intersect(parts.value.size());
    }
  }

  static Placement read_placement(const std::string& kind, const Place& content) {
    Placement placement;
    if (kind == "translate") {
      placement.translation = read_vector(content);
    } else if (kind == "scale") {
      placement.scale = read_length(content);
    } else {
      allow_keys(content, {"axis", "degrees"});
      const double angle = read_number(content.at("degrees")) * std::numbers::pi / 180.0;
      placement.rotation = Eigen::AngleAxisd(angle, read_direction(content.at("axis")));
    }
    return placement;
  }

  void read_primitive(const std::string& kind, const Place& content, const Placement& placement,
                      bool is_inside) {
    if (kind == "sphere") return read_sphere(content, placement, is_inside);
    if (kind == "box") return read_box(content, placement, is_inside);
    if (kind == "cylinder") return read_cylinder(content, placement, is_inside);
    if (kind == "torus") return read_torus(content, placement, is_inside);
    if (kind == "halfspace") return read_half_space(content, placement, is_inside);
    content.refuse(
        "is none of sphere, box, cylinder, torus, halfspace, union, intersection, difference, "
        "translate, rotate and scale");
  }

  void add(const Surface& surface, bool is_inside, const AlignedBox3d& bounds) {
    builder_.add(surface, is_inside, is_inside ? bounds : unbounded_box());
  }

  void add_all(std::initializer_list<Surface> surfaces, bool is_inside,
               const AlignedBox3d& bounds) {
    for (const Surface& surface : surfaces) add(surface, is_inside, bounds);
    if (is_inside) {
      builder_.intersect(surfaces.size());
    } else {
      builder_.unite(surfaces.size());
    }
  }

  static Surface plane(const Placement& placement, const Vector3d& point, const Vector3d& outward) {
    return {.kind = Surface::Kind::plane,
            .point = placement.point(point),
            .axis = placement.direction(outward)};
  }

  void read_sphere(const Place& content, const Placement& placement, bool is_inside) {
    allow_keys(content, {"center", "radius"});
    const Surface sphere = {.kind = Surface::Kind::sphere,
                            .point = placement.point(read_center(content)),
                            .radius = placement.scale * read_length(content.at("radius"))};
    add(sphere, is_inside, box_around(sphere.point, Vector3d::Constant(sphere.radius)));
  }

  void read_box(const Place& content, const Placement& placement, bool is_inside) {
    allow_keys(content, {"min", "max"});
    const Vector3d low = read_vector(content.at("min"));
    const Vector3d high = read_vector(content.at("max"));
    if (!((high - low).minCoeff() >= 1.0 / largest_number)) {
      content.refuse("\"max\" must be above \"min\" in all three");
    }
    const Vector3d reach = placement.scale * (placement.rotation.cwiseAbs() * (0.5 * (high - low)));
    const Vector3d x = Vector3d::UnitX();
    const Vector3d y = Vector3d::UnitY();
    const Vector3d z = Vector3d::UnitZ();
    add_all({plane(placement, low, -x), plane(placement, high, x), plane(placement, low, -y),
             plane(placement, high, y), plane(placement, low, -z), plane(placement, high, z)},
            is_inside, box_around(placement.point(0.5 * (low + high)), reach));
  }

  void read_cylinder(const Place& content, const Placement& placement, bool is_inside) {
    allow_keys(content, {"from", "to", "radius"});
    const Vector3d from = read_vector(content.at("from"));
    const Vector3d to = read_vector(content.at("to"));
    if (!((to - from).norm() >= 1.0 / largest_number)) {
      content.refuse("\"from\" and \"to\" must be different");
    }
    const Vector3d along = (to - from).stableNormalized();
    const Surface side = {.kind = Surface::Kind::cylinder,
                          .point = placement.point(0.5 * (from + to)),
                          .axis = placement.direction(along),
                          .radius = placement.scale * read_length(content.at("radius"))};
    const Vector3d reach = 0.5 * placement.scale * (to - from).norm() * side.axis.cwiseAbs() +
                           disc_reach(side.axis, side.radius);
    add_all({side, plane(placement, from, -along), plane(placement, to, along)}, is_inside,
            box_around(side.point, reach));
  }

  void read_torus(const Place& content, const Placement& placement, bool is_inside) {
    allow_keys(content, {"center", "axis", "radius", "tube_radius"});
    const Surface torus = {.kind = Surface::Kind::torus,
                           .point = placement.point(read_center(content)),
                           .axis = placement.direction(content.value.contains("axis")
                                                           ? read_direction(content.at("axis"))
                                                           : Vector3d(Vector3d::UnitZ())),
                           .radius = placement.scale * read_length(content.at("radius")),
                           .tube_radius = placement.scale * read_length(content.at("tube_radius"))};
    if (!(torus.tube_radius < torus.radius)) {
      content.at("tube_radius").refuse("must be below the radius of the torus");
    }
    const Vector3d reach =
        disc_reach(torus.axis, torus.radius) + Vector3d::Constant(torus.tube_radius);
    add(torus, is_inside, box_around(torus.point, reach));
  }

  void read_half_space(const Place& content, const Placement& placement, bool is_inside) {
    allow_keys(content, {"point", "outward"});
    const Surface half_space =
        plane(placement, read_vector(content.at("point")), read_direction(content.at("outward")));
    // An axis-aligned one bounds one side.
    AlignedBox3d bounds = unbounded_box();
    const double sign = is_inside ? 1.0 : -1.0;
    for (int i = 0; i < 3; ++i) {
      if (sign * half_space.axis[i] == 1.0) bounds.max()[i] = half_space.point[i];
      if (sign * half_space.axis[i] == -1.0) bounds.min()[i] = half_space.point[i];
    }
    builder_.add(half_space, is_inside, bounds);
  }

  CsgBuilder builder_;
  int primitives_ = 0;
};

json parse(std::string_view bytes) {
  try {
    return json::parse(bytes);
  } catch (const json::exception& error) {
    const std::string_view what = error.what();
    const std::size_t start = what.find("] ");
    std::string reason(start == what.npos ? what : what.substr(start + 2, 200));
    std::ranges::replace_if(
        reason, [](char c) { return c < ' ' || c > '~'; }, '?');
    throw InvalidInput("no JSON document: " + reason);
  }
}

}  // namespace

CsgSolid read_csg(std::string_view bytes) {
  const json document = parse(bytes);
  const Place root{document, ""};
  if (!document.is_object() || document.value("format", json()) != csg_format) {
    throw InvalidInput("the JSON document is no solid: it has no \"format\": \"mdbd-csg\"");
  }
  allow_keys(root, {"format", "name", "solid"});
  return CsgReader().read(root.at("solid"));
}

}  // namespace mdbd
