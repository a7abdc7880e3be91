# The target mdbd_flann; used by the build and by the installed package.
# FLANN's own package files pull in HDF5 and MPI, which its templates do not need.
if(NOT TARGET mdbd_flann)
  find_path(FLANN_INCLUDE_DIR flann/flann.hpp REQUIRED)
  find_library(FLANN_LIBRARY flann_cpp REQUIRED)
  find_library(LZ4_LIBRARY lz4 REQUIRED)
  add_library(mdbd_flann INTERFACE IMPORTED)
  target_include_directories(mdbd_flann SYSTEM INTERFACE ${FLANN_INCLUDE_DIR})
  target_link_libraries(mdbd_flann INTERFACE ${FLANN_LIBRARY} ${LZ4_LIBRARY})
endif()
