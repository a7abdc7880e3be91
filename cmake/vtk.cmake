# The target mdbd_vtk.
# Of VTK only the reader of image data in XML and the iso-surface are used: libraries by name, since
# its own package file looks for the needs of all others, too.
if(NOT TARGET mdbd_vtk)
  find_path(VTK_INCLUDE_DIR vtkImageData.h PATH_SUFFIXES vtk-9.1 REQUIRED)
  add_library(mdbd_vtk INTERFACE IMPORTED)
  target_include_directories(mdbd_vtk SYSTEM INTERFACE ${VTK_INCLUDE_DIR})
  foreach(library CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc FiltersCore IOXML
                  IOXMLParser)
    find_library(VTK_${library}_LIBRARY vtk${library}-9.1 REQUIRED)
    target_link_libraries(mdbd_vtk INTERFACE ${VTK_${library}_LIBRARY})
  endforeach()
endif()
