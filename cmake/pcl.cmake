# The targets mdbd_pcl and, for files, mdbd_pcl_io, which brings VTK; used by the build and by the installed package.
# PCL's own package files pull in HDF5, MPI and VTK's headers, which files, neighbourhoods and
# features do not need: its headers and settings come from the smallest package, the other libraries
# by name.
if(NOT TARGET mdbd_pcl)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(PCL REQUIRED QUIET IMPORTED_TARGET pcl_common>=1.12)
  add_library(mdbd_pcl INTERFACE IMPORTED)
  foreach(library search kdtree)
    find_library(PCL_${library}_LIBRARY pcl_${library} HINTS ${PCL_LIBRARY_DIRS} REQUIRED)
    target_link_libraries(mdbd_pcl INTERFACE ${PCL_${library}_LIBRARY})
  endforeach()
  target_link_libraries(mdbd_pcl INTERFACE PkgConfig::PCL)
  find_library(PCL_io_LIBRARY pcl_io HINTS ${PCL_LIBRARY_DIRS} REQUIRED)
  add_library(mdbd_pcl_io INTERFACE IMPORTED)
  target_link_libraries(mdbd_pcl_io INTERFACE ${PCL_io_LIBRARY} mdbd_pcl)
endif()
