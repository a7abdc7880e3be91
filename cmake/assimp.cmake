# The target mdbd_assimp.
# assimp's own package file asks for minizip's and draco's targets, which its shared library does
# not need.
if(NOT TARGET mdbd_assimp)
  find_path(ASSIMP_INCLUDE_DIR assimp/scene.h REQUIRED)
  find_library(ASSIMP_LIBRARY assimp REQUIRED)
  add_library(mdbd_assimp INTERFACE IMPORTED)
  target_include_directories(mdbd_assimp SYSTEM INTERFACE ${ASSIMP_INCLUDE_DIR})
  target_link_libraries(mdbd_assimp INTERFACE ${ASSIMP_LIBRARY})
endif()
