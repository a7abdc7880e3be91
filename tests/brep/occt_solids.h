#pragma once

#include <filesystem>
#include <memory>

#include <Eigen/Geometry>

/// Solids that OpenCASCADE makes, writes and measures, as oracles of our own measures.
namespace mdbd::test {

class OcctSolid {
 public:
  static OcctSolid box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper);
  /// Along z from the origin.
  static OcctSolid cylinder(double radius, double height);
  static OcctSolid cone(double lower_radius, double upper_radius, double height);
  static OcctSolid sphere(double radius);
  static OcctSolid torus(double radius, double minor_radius);
  /// A spline of wavy outline, turned around z: all faces but two are B-spline or revolved ones.
  static OcctSolid vase();

  OcctSolid with_fillets(double radius) const;  ///< on all edges
  OcctSolid without(const OcctSolid& other) const;
  OcctSolid beside(const OcctSolid& other) const;  ///< an assembly
  OcctSolid moved(const Eigen::Isometry3d& motion) const;
  OcctSolid as_splines() const;      ///< the same, each surface as rational B-splines
  OcctSolid inside_out() const;      ///< of negative volume
  OcctSolid face(int number) const;  ///< one of its faces alone, from 1

  void write_step(const std::filesystem::path& path, const char* unit = "MM") const;
  /// @param as_faces without solids and shells, the faces alone
  void write_iges(const std::filesystem::path& path, bool as_faces = false) const;

  /// The distance from the boundary, positive inside, by OpenCASCADE.
  double signed_distance(const Eigen::Vector3d& point) const;

 private:
  struct Shape;
  explicit OcctSolid(std::shared_ptr<const Shape> shape) : shape_(std::move(shape)) {}
  std::shared_ptr<const Shape> shape_;
};

}  // namespace mdbd::test
