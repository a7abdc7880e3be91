#include "tests/brep/occt_solids.h"

#include <stdexcept>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax1.hxx>

namespace mdbd::test {

struct OcctSolid::Shape {
  TopoDS_Shape shape;
  TopoDS_Shape measured = shape;  // the same set of points
};

namespace {

gp_Pnt to_point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

TopoDS_Shape collect(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (TopExp_Explorer it(shape, kind); it.More(); it.Next()) builder.Add(all, it.Current());
  return all;
}

void silence() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

}  // namespace

#define MDBD_SOLID(shape) OcctSolid(std::make_shared<const Shape>(Shape{shape}))

OcctSolid OcctSolid::box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  return MDBD_SOLID(BRepPrimAPI_MakeBox(to_point(lower), to_point(upper)).Solid());
}
OcctSolid OcctSolid::cylinder(double radius, double height) {
  return MDBD_SOLID(BRepPrimAPI_MakeCylinder(radius, height).Solid());
}
OcctSolid OcctSolid::cone(double lower_radius, double upper_radius, double height) {
  return MDBD_SOLID(BRepPrimAPI_MakeCone(lower_radius, upper_radius, height).Solid());
}
OcctSolid OcctSolid::sphere(double radius) {
  return MDBD_SOLID(BRepPrimAPI_MakeSphere(radius).Solid());
}
OcctSolid OcctSolid::torus(double radius, double minor_radius) {
  return MDBD_SOLID(BRepPrimAPI_MakeTorus(radius, minor_radius).Solid());
}

OcctSolid OcctSolid::vase() {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 5);
  const double radii[] = {1.0, 1.6, 0.9, 1.3, 1.1};
  for (int i = 0; i < 5; ++i) points->SetValue(i + 1, gp_Pnt(radii[i], 0.0, i));
  GeomAPI_Interpolate interpolate(points, Standard_False, 1e-9);
  interpolate.Perform();
  const gp_Pnt low(0, 0, 0);
  const gp_Pnt high(0, 0, 4);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(low, points->Value(1)));
  wire.Add(BRepBuilderAPI_MakeEdge(interpolate.Curve()));
  wire.Add(BRepBuilderAPI_MakeEdge(points->Value(5), high));
  wire.Add(BRepBuilderAPI_MakeEdge(high, low));
  const TopoDS_Face outline = BRepBuilderAPI_MakeFace(wire.Wire());
  return MDBD_SOLID(BRepPrimAPI_MakeRevol(outline, gp::OZ()).Shape());
}

OcctSolid OcctSolid::with_fillets(double radius) const {
  BRepFilletAPI_MakeFillet fillet(shape_->shape);
  for (TopExp_Explorer it(shape_->shape, TopAbs_EDGE); it.More(); it.Next()) {
    fillet.Add(radius, TopoDS::Edge(it.Current()));
  }
  return MDBD_SOLID(fillet.Shape());
}

OcctSolid OcctSolid::without(const OcctSolid& other) const {
  return MDBD_SOLID(BRepAlgoAPI_Cut(shape_->shape, other.shape_->shape).Shape());
}

OcctSolid OcctSolid::beside(const OcctSolid& other) const {
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, shape_->shape);
  builder.Add(both, other.shape_->shape);
  return MDBD_SOLID(both);
}

OcctSolid OcctSolid::moved(const Eigen::Isometry3d& motion) const {
  const auto& m = motion.matrix();
  gp_Trsf trsf;
  trsf.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0),
                 m(2, 1), m(2, 2), m(2, 3));
  return MDBD_SOLID(BRepBuilderAPI_Transform(shape_->shape, trsf, Standard_True).Shape());
}

OcctSolid OcctSolid::as_splines() const {
  // OpenCASCADE tells inside from outside less surely where surfaces are splines.
  const TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(shape_->shape, Standard_True).Shape();
  return OcctSolid(std::make_shared<const Shape>(Shape{splines, shape_->shape}));
}

OcctSolid OcctSolid::inside_out() const { return MDBD_SOLID(shape_->shape.Reversed()); }

OcctSolid OcctSolid::face(int number) const {
  TopExp_Explorer it(shape_->shape, TopAbs_FACE);
  while (--number > 0) it.Next();
  return MDBD_SOLID(it.Current());
}

void OcctSolid::write_step(const std::filesystem::path& path, const char* unit) const {
  silence();
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", unit);
  STEPControl_Writer writer;
  writer.Transfer(shape_->shape, STEPControl_AsIs);
  if (writer.Write(path.c_str()) != IFSelect_RetDone) throw std::runtime_error("not written");
}

void OcctSolid::write_iges(const std::filesystem::path& path, bool as_faces) const {
  silence();
  IGESControl_Controller::Init();
  IGESControl_Writer writer("MM", as_faces ? 0 : 1);
  writer.AddShape(as_faces ? collect(shape_->shape, TopAbs_FACE) : shape_->shape);
  writer.ComputeModel();
  if (!writer.Write(path.c_str())) throw std::runtime_error("not written");
}

double OcctSolid::signed_distance(const Eigen::Vector3d& point) const {
  const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(to_point(point));
  const TopoDS_Shape boundary = collect(shape_->measured, TopAbs_SHELL);
  const double distance = BRepExtrema_DistShapeShape(vertex, boundary).Value();
  for (TopExp_Explorer it(shape_->measured, TopAbs_SOLID); it.More(); it.Next()) {
    const BRepClass3d_SolidClassifier classifier(it.Current(), to_point(point), 1e-9);
    if (classifier.State() == TopAbs_IN) return distance;
  }
  return -distance;
}

}  // namespace mdbd::test
