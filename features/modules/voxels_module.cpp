#include "features/modules/module.h"
#include "features/modules/readers.h"

MDBD_MODULE const mdbd::VoxelModule mdbd_module = {mdbd::read_vti, mdbd::find_iso_surface};
