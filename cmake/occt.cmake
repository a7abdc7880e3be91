# The target mdbd_occt.
# OpenCASCADE's own package file asks for the libraries of all its modules, X11 among them; of these
# the readers need ten.
if(NOT TARGET mdbd_occt)
  find_path(OCCT_INCLUDE_DIR Standard_Version.hxx PATH_SUFFIXES opencascade REQUIRED)
  add_library(mdbd_occt INTERFACE IMPORTED)
  target_include_directories(mdbd_occt SYSTEM INTERFACE ${OCCT_INCLUDE_DIR})
  foreach(library TKSTEP TKIGES TKXSBase TKShHealing TKMesh TKTopAlgo TKBRep TKGeomBase TKG3d TKG2d
                  TKMath TKernel)
    find_library(OCCT_${library}_LIBRARY ${library} REQUIRED)
    target_link_libraries(mdbd_occt INTERFACE ${OCCT_${library}_LIBRARY})
  endforeach()
endif()
