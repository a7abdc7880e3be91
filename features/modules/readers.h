#pragma once

#include "features/brep/read_brep.h"
#include "features/shape_io/assimp_reader.h"
#include "features/shape_io/point_formats.h"
#include "features/shape_io/vti_reader.h"
#include "features/voxel/iso_surface.h"

/// What the modules of readers hold (module.h). Each function is that of its header, where callers
/// find it: in programs it calls the module (on_demand.cpp), in the module it is the reader itself.
namespace mdbd {

/// OpenCASCADE.
struct CadModule {
  static constexpr const char* module_name = "mdbd_cad";
  decltype(&mdbd::read_brep) read_brep;
  decltype(&mdbd::count_solids) count_solids;
};

/// assimp.
struct SceneModule {
  static constexpr const char* module_name = "mdbd_scenes";
  decltype(&mdbd::read_with_assimp) read_with_assimp;
};

/// VTK.
struct VoxelModule {
  static constexpr const char* module_name = "mdbd_voxels";
  decltype(&mdbd::read_vti) read_vti;
  decltype(&mdbd::find_iso_surface) find_iso_surface;
};

/// PCL's input and output, which brings VTK's.
struct PcdModule {
  static constexpr const char* module_name = "mdbd_pcd";
  decltype(&mdbd::read_pcd) read_pcd;
};

}  // namespace mdbd
