#include "features/modules/module.h"
#include "features/modules/readers.h"

MDBD_MODULE const mdbd::CadModule mdbd_module = {mdbd::read_brep, mdbd::count_solids};
