#pragma once

#include <filesystem>
#include <string>

#include <TopoDS_Shape.hxx>

#include "features/brep/brep.h"

/// The sources that see OpenCASCADE; nothing else includes this header.
namespace mdbd {

struct OcctFile {
  TopoDS_Shape shape;
  std::string format;
  std::string unit;  ///< as the file names it
};

/// @throws IoError, InvalidInput as read_brep(); Standard_Failure
OcctFile read_occt_file(const std::filesystem::path& path);

/// Tessellates a shape and collects its faces and edges.
/// @throws InvalidInput if a face cannot be tessellated; Standard_Failure
Brep make_brep(const TopoDS_Shape& shape);

}  // namespace mdbd
