// Chooses what of a file is measured.
#include "features/brep/read_brep.h"

#include <string_view>

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <fmt/format.h>

#include "features/brep/occt_shape.h"
#include "features/core/errors.h"

namespace mdbd {
namespace {

// By how much the edges of faces that are to be sewn may differ; millimetres.
constexpr double sewing_tolerance = 1e-3;

std::size_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind,
                  TopAbs_ShapeEnum outside = TopAbs_SHAPE) {
  std::size_t number = 0;
  for (TopExp_Explorer it(shape, kind, outside); it.More(); it.Next()) ++number;
  return number;
}

// A solid that is inside out has a negative volume.
bool turn_outward(TopoDS_Shape& solid) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  if (properties.Mass() >= 0) return false;
  solid.Reverse();
  return true;
}

TopoDS_Shape collect_solids(const TopoDS_Shape& shape, std::size_t wanted, BrepFile& file) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) {
    ++file.solids;
    if (wanted != 0 && file.solids != wanted) continue;
    TopoDS_Shape solid = it.Current();
    if (turn_outward(solid)) ++file.solids_turned;
    builder.Add(all, solid);
  }
  if (wanted > file.solids) throw InvalidInput(fmt::format("has no solid {}", wanted));
  return all;
}

/// Solids of faces that have none, or the faces themselves if these do not close.
TopoDS_Shape sew(const TopoDS_Shape& shape) {
  BRepBuilderAPI_Sewing sewing(sewing_tolerance);
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) sewing.Add(it.Current());
  sewing.Perform();
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (TopExp_Explorer it(sewing.SewedShape(), TopAbs_SHELL); it.More(); it.Next()) {
    if (!BRep_Tool::IsClosed(it.Current())) return sewing.SewedShape();
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, it.Current());
    builder.Add(all, solid);
  }
  if (count(sewing.SewedShape(), TopAbs_FACE, TopAbs_SHELL) > 0) return sewing.SewedShape();
  return all;
}

/// Reads a file whose shape holds solids, or faces that make none.
OcctFile read_solids(const std::filesystem::path& path, BrepFile& file) {
  OcctFile read = read_occt_file(path);
  file.is_sewn = count(read.shape, TopAbs_SOLID) == 0;
  if (!file.is_sewn) return read;
  if (count(read.shape, TopAbs_FACE) == 0) {
    throw InvalidInput("holds no faces: curves or points only, or nothing that is understood");
  }
  read.shape = sew(read.shape);
  return read;
}

BrepFile read(const std::filesystem::path& path, std::size_t wanted) {
  BrepFile file;
  const OcctFile read = read_solids(path, file);
  file.format = read.format;
  file.file_unit = read.unit;
  const bool is_solid = count(read.shape, TopAbs_SOLID) > 0;
  file.faces_ignored = is_solid ? count(read.shape, TopAbs_FACE, TopAbs_SOLID) : 0;
  const TopoDS_Shape chosen =
      is_solid || wanted > 0 ? collect_solids(read.shape, wanted, file) : read.shape;
  file.faces = count(chosen, TopAbs_FACE);
  if (file.faces == 0) throw InvalidInput("holds no faces that could be used");
  file.brep = make_brep(chosen);
  return file;
}

/// Calls a function; a failure of OpenCASCADE is one of the file.
template <typename Function>
auto explain_failures(const Function& function) {
  try {
    return function();
  } catch (const Standard_Failure& failure) {
    const std::string_view text = failure.GetMessageString();
    throw InvalidInput(fmt::format("damaged: {}{}{}", failure.DynamicType()->Name(),
                                   text.empty() ? "" : ": ", text));
  }
}

}  // namespace

BrepFile read_brep(const std::filesystem::path& path, std::size_t solid) {
  return explain_failures([&] { return read(path, solid); });
}

std::size_t count_solids(const std::filesystem::path& path) {
  BrepFile file;
  return explain_failures([&] { return count(read_solids(path, file).shape, TopAbs_SOLID); });
}

}  // namespace mdbd
