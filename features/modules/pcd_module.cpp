#include "features/modules/module.h"
#include "features/modules/readers.h"

MDBD_MODULE const mdbd::PcdModule mdbd_module = {mdbd::read_pcd};
