// OpenCASCADE's shapes -> our own boundary representation.
#include <set>

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Eigen/Geometry>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_Surface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>

#include "features/brep/bspline.h"
#include "features/brep/occt_shape.h"
#include "features/brep/refine_tessellation.h"
#include "features/core/errors.h"

namespace mdbd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Of the tessellation, relative to the diagonal of the bounding box.
constexpr double relative_deflection = 2e-4;
constexpr double angular_deflection = 0.5;  // radians
// Where OpenCASCADE has no nodes of an edge.
constexpr int default_segments = 32;

Vector3d to_vector(const gp_XYZ& v) { return {v.X(), v.Y(), v.Z()}; }
Vector2d to_vector(const gp_XY& v) { return {v.X(), v.Y()}; }

[[noreturn]] void throw_singular() { throw InvalidInput("a curve or surface cannot be evaluated"); }

class OcctSurface final : public ParametricSurface {
 public:
  explicit OcctSurface(Handle(Geom_Surface) surface) : surface_(std::move(surface)) {}
  SurfacePoint at(const Vector2d& uv) const override {
    try {
      gp_Pnt p;
      gp_Vec du;
      gp_Vec dv;
      gp_Vec duu;
      gp_Vec dvv;
      gp_Vec duv;
      surface_->D2(uv.x(), uv.y(), p, du, dv, duu, dvv, duv);
      return {to_vector(p.XYZ()),   to_vector(du.XYZ()),  to_vector(dv.XYZ()),
              to_vector(duu.XYZ()), to_vector(dvv.XYZ()), to_vector(duv.XYZ())};
    } catch (const Standard_Failure&) {
      throw_singular();
    }
  }

 private:
  Handle(Geom_Surface) surface_;
};

class OcctCurve final : public ParametricCurve {
 public:
  explicit OcctCurve(Handle(Geom_Curve) curve) : curve_(std::move(curve)) {}
  CurvePoint at(double t) const override {
    try {
      gp_Pnt p;
      gp_Vec first;
      gp_Vec second;
      curve_->D2(t, p, first, second);
      return {to_vector(p.XYZ()), to_vector(first.XYZ()), to_vector(second.XYZ())};
    } catch (const Standard_Failure&) {
      throw_singular();
    }
  }

 private:
  Handle(Geom_Curve) curve_;
};

class OcctParameterCurve final : public ParameterCurve {
 public:
  explicit OcctParameterCurve(Handle(Geom2d_Curve) curve) : curve_(std::move(curve)) {}
  Vector2d at(double t) const override {
    try {
      return to_vector(curve_->Value(t).XY());
    } catch (const Standard_Failure&) {
      throw_singular();
    }
  }

 private:
  Handle(Geom2d_Curve) curve_;
};

BsplineBasis to_basis(int degree, const TColStd_Array1OfReal& knots) {
  return {degree, std::vector<double>(knots.begin(), knots.end())};
}

Eigen::Vector4d to_pole(const gp_Pnt& point, double weight) {
  Eigen::Vector4d pole;
  pole << weight * to_vector(point.XYZ()), weight;
  return pole;
}

std::shared_ptr<const ParametricSurface> make_surface(const Handle(Geom_Surface) & surface) {
  const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (spline.IsNull()) return std::make_shared<OcctSurface>(surface);
  const auto copy = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
  copy->SetUNotPeriodic();
  copy->SetVNotPeriodic();
  std::vector<Eigen::Vector4d> poles;
  for (int i = 1; i <= copy->NbUPoles(); ++i) {
    for (int j = 1; j <= copy->NbVPoles(); ++j) {
      poles.push_back(to_pole(copy->Pole(i, j), copy->Weight(i, j)));
    }
  }
  return std::make_shared<BsplineSurface>(to_basis(copy->UDegree(), copy->UKnotSequence()),
                                          to_basis(copy->VDegree(), copy->VKnotSequence()),
                                          std::move(poles));
}

std::shared_ptr<const ParametricCurve> make_curve(const Handle(Geom_Curve) & curve) {
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  if (spline.IsNull()) return std::make_shared<OcctCurve>(curve);
  const auto copy = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
  copy->SetNotPeriodic();
  std::vector<Eigen::Vector4d> poles;
  for (int i = 1; i <= copy->NbPoles(); ++i)
    poles.push_back(to_pole(copy->Pole(i), copy->Weight(i)));
  return std::make_shared<BsplineCurve>(to_basis(copy->Degree(), copy->KnotSequence()),
                                        std::move(poles));
}

Placement to_placement(const gp_Ax3& frame) {
  return {.origin = to_vector(frame.Location().XYZ()),
          .x = to_vector(frame.XDirection().XYZ()),
          .y = to_vector(frame.YDirection().XYZ()),
          .z = to_vector(frame.Direction().XYZ())};
}

Handle(Geom_Surface) untrimmed(Handle(Geom_Surface) surface) {
  while (true) {
    const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
    if (trimmed.IsNull()) return surface;
    surface = trimmed->BasisSurface();
  }
}

Handle(Geom_Curve) untrimmed(Handle(Geom_Curve) curve) {
  while (true) {
    const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve);
    if (trimmed.IsNull()) return curve;
    curve = trimmed->BasisCurve();
  }
}

bool is_straight_line(Handle(Geom2d_Curve) curve) {
  while (true) {
    const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve);
    if (trimmed.IsNull()) return !Handle(Geom2d_Line)::DownCast(curve).IsNull();
    curve = trimmed->BasisCurve();
  }
}

void set_kind(BrepFace& face, const Handle(Geom_Surface) & surface) {
  if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull()) {
    face.kind = SurfaceKind::plane;
    face.placement = to_placement(plane->Position());
  } else if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface);
             !cylinder.IsNull()) {
    face.kind = SurfaceKind::cylinder;
    face.placement = to_placement(cylinder->Position());
    face.placement.radius = cylinder->Radius();
  } else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) {
    face.kind = SurfaceKind::cone;
    face.placement = to_placement(cone->Position());
    face.placement.radius = cone->RefRadius();
    face.placement.angle = cone->SemiAngle();
  } else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface);
             !sphere.IsNull()) {
    face.kind = SurfaceKind::sphere;
    face.placement = to_placement(sphere->Position());
    face.placement.radius = sphere->Radius();
  } else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface);
             !torus.IsNull() && torus->MinorRadius() <= torus->MajorRadius()) {
    face.kind = SurfaceKind::torus;
    face.placement = to_placement(torus->Position());
    face.placement.radius = torus->MajorRadius();
    face.placement.minor_radius = torus->MinorRadius();
  }
}

bool is_outline(const TopoDS_Edge& edge) {
  return edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
}

Handle(Geom_Curve) curve_of(const TopoDS_Edge& edge, double& first, double& last) {
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  return curve.IsNull() ? curve : untrimmed(curve);
}

bool is_line(const TopoDS_Edge& edge) {
  double first;
  double last;
  return !Handle(Geom_Line)::DownCast(curve_of(edge, first, last)).IsNull();
}

/// The nodes of an edge on the tessellation of a face.
struct EdgeNodes {
  Handle(Poly_PolygonOnTriangulation) polygon;

  EdgeNodes(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & triangulation,
            const TopLoc_Location& location)
      : polygon(BRep_Tool::PolygonOnTriangulation(edge, triangulation, location)) {}

  bool is_known() const { return !polygon.IsNull() && polygon->NbNodes() > 1; }
  bool has_parameters() const { return is_known() && polygon->HasParameters(); }
};

class Builder {
 public:
  explicit Builder(const TopoDS_Shape& shape) : shape_(shape) {}

  Brep run() {
    tessellate();
    for (TopExp_Explorer it(shape_, TopAbs_FACE); it.More(); it.Next()) {
      add_face(TopoDS::Face(it.Current()));
    }
    refine_tessellation(brep_, deflection_);
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape_, properties);
    brep_.centroid = to_vector(properties.CentreOfMass().XYZ());
    brep_.is_closed = is_closed();
    return std::move(brep_);
  }

 private:
  void tessellate() {
    Bnd_Box box;
    BRepBndLib::Add(shape_, box);
    if (box.IsVoid()) throw InvalidInput("the shape has no extent");
    BRepLib::BuildCurves3d(shape_);
    const double size = std::sqrt(box.SquareExtent());
    if (!(size > 0 && std::isfinite(size))) throw InvalidInput("the shape has no extent");
    deflection_ = relative_deflection * size;
    const BRepMesh_IncrementalMesh mesh(shape_, deflection_, Standard_False, angular_deflection,
                                        Standard_False);
  }

  // Two faces meet in each edge, or one meets itself.
  bool is_closed() const {
    TopTools_IndexedDataMapOfShapeListOfShape faces_of;
    TopExp::MapShapesAndAncestors(shape_, TopAbs_EDGE, TopAbs_FACE, faces_of);
    for (int i = 1; i <= faces_of.Extent(); ++i) {
      const TopoDS_Edge& edge = TopoDS::Edge(faces_of.FindKey(i));
      if (BRep_Tool::Degenerated(edge) || !is_outline(edge)) continue;
      if (faces_of(i).Extent() % 2 != 0) return false;
    }
    return true;
  }

  void add_face(const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
    if (triangulation.IsNull() || triangulation->NbTriangles() == 0 ||
        !triangulation->HasUVNodes()) {
      throw InvalidInput("a face cannot be tessellated");
    }
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (surface.IsNull()) throw InvalidInput("a face has no surface");
    BrepFace added;
    const Handle(Geom_Surface) basis = untrimmed(surface);
    set_kind(added, basis);
    added.surface = make_surface(basis);
    if (basis->IsUPeriodic()) added.period.x() = basis->UPeriod();
    if (basis->IsVPeriodic()) added.period.y() = basis->VPeriod();
    added.is_reversed = face.Orientation() == TopAbs_REVERSED;
    add_outline(added, face, triangulation, location);
    add_triangles(added, triangulation, location);
    brep_.faces.push_back(std::move(added));
  }

  void add_outline(BrepFace& added, const TopoDS_Face& face,
                   const Handle(Poly_Triangulation) & triangulation,
                   const TopLoc_Location& location) {
    added.is_polygon = added.kind == SurfaceKind::plane;
    chords_.clear();
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (!is_outline(edge)) continue;
      const EdgeNodes nodes(edge, triangulation, location);
      add_sides(added, edge, face, nodes, triangulation);
      if (BRep_Tool::Degenerated(edge) || is_line(edge)) continue;
      added.is_polygon = false;
      for (int i = 1; nodes.is_known() && i < nodes.polygon->NbNodes(); ++i) {
        chords_.insert(std::minmax(nodes.polygon->Node(i), nodes.polygon->Node(i + 1)));
      }
    }
    if (added.is_polygon) return;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      add_edge(edge, EdgeNodes(edge, triangulation, location));
    }
  }

  void add_sides(BrepFace& added, const TopoDS_Edge& edge, const TopoDS_Face& face,
                 const EdgeNodes& nodes, const Handle(Poly_Triangulation) & triangulation) {
    double first;
    double last;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    std::shared_ptr<const ParameterCurve> shared;
    if (!curve.IsNull()) shared = std::make_shared<OcctParameterCurve>(curve);
    const bool is_straight = !curve.IsNull() && is_straight_line(curve);
    if (!nodes.has_parameters()) {
      if (!shared) throw InvalidInput("an edge has no place on its face");
      for (int i = 0; i < default_segments; ++i) {
        const double from = first + (last - first) * i / default_segments;
        const double to = first + (last - first) * (i + 1) / default_segments;
        added.outline.push_back({shared->at(from), shared->at(to), from, to, shared});
      }
      return;
    }
    const Poly_PolygonOnTriangulation& polygon = *nodes.polygon;
    for (int i = 1; i < polygon.NbNodes(); ++i) {
      added.outline.push_back({to_vector(triangulation->UVNode(polygon.Node(i)).XY()),
                               to_vector(triangulation->UVNode(polygon.Node(i + 1)).XY()),
                               polygon.Parameter(i), polygon.Parameter(i + 1),
                               is_straight ? nullptr : shared});
    }
  }

  void add_edge(const TopoDS_Edge& edge, const EdgeNodes& nodes) {
    if (BRep_Tool::Degenerated(edge) || edges_.Contains(edge)) return;
    edges_.Add(edge);
    BrepEdge added;
    double first;
    double last;
    const Handle(Geom_Curve) curve = curve_of(edge, first, last);
    if (curve.IsNull()) throw InvalidInput("an edge has no curve");
    added.curve = make_curve(curve);
    if (!Handle(Geom_Line)::DownCast(curve).IsNull()) {
      added.kind = CurveKind::line;
      added.parameters = {first, last};
    } else if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull()) {
      added.kind = CurveKind::circle;
      added.placement = to_placement(gp_Ax3(circle->Position()));
      added.placement.radius = circle->Radius();
    }
    if (added.kind != CurveKind::line) {
      const int segments = nodes.has_parameters() ? nodes.polygon->NbNodes() - 1 : default_segments;
      for (int i = 0; i <= segments; ++i) {
        added.parameters.push_back(nodes.has_parameters() ? nodes.polygon->Parameter(i + 1)
                                                          : first + (last - first) * i / segments);
      }
    }
    brep_.edges.push_back(std::move(added));
  }

  void add_triangles(const BrepFace& face, const Handle(Poly_Triangulation) & triangulation,
                     const TopLoc_Location& location) {
    const auto base = static_cast<std::uint32_t>(brep_.mesh.vertices.size()) - 1;
    const gp_Trsf transformation = location.Transformation();
    for (int i = 1; i <= triangulation->NbNodes(); ++i) {
      const gp_Pnt node = triangulation->Node(i).Transformed(transformation);
      brep_.mesh.vertices.push_back(to_vector(node.XYZ()));
      brep_.parameters.push_back(to_vector(triangulation->UVNode(i).XY()));
      if (!brep_.mesh.vertices.back().allFinite()) throw InvalidInput("coordinates overflow");
    }
    const auto number = static_cast<std::uint32_t>(brep_.faces.size());
    for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
      std::array<int, 3> nodes;
      triangulation->Triangle(i).Get(nodes[0], nodes[1], nodes[2]);
      if (face.is_reversed) std::swap(nodes[1], nodes[2]);
      Triangle corners;
      std::array<bool, 3> is_chord;
      for (int side = 0; side < 3; ++side) {
        corners[side] = base + static_cast<std::uint32_t>(nodes[side]);
        is_chord[side] = chords_.contains(std::minmax(nodes[side], nodes[(side + 1) % 3]));
      }
      if (!has_area(corners)) continue;
      brep_.mesh.triangles.push_back(corners);
      brep_.is_chord.push_back(is_chord);
      brep_.face_of.push_back(number);
    }
  }

  bool has_area(const Triangle& corners) const {
    const auto& [a, b, c] = corners;
    const Vector3d& origin = brep_.mesh.vertices[a];
    return (brep_.mesh.vertices[b] - origin).cross(brep_.mesh.vertices[c] - origin).norm() > 0;
  }

  const TopoDS_Shape& shape_;
  Brep brep_;
  double deflection_ = 0.0;
  TopTools_IndexedMapOfShape edges_;      ///< those that were added
  std::set<std::pair<int, int>> chords_;  ///< of the curved edges of a face, by nodes
};

}  // namespace

Brep make_brep(const TopoDS_Shape& shape) { return Builder(shape).run(); }

}  // namespace mdbd
