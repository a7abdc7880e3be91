#include "features/modules/module.h"
#include "features/modules/readers.h"

MDBD_MODULE const mdbd::SceneModule mdbd_module = {mdbd::read_with_assimp};
