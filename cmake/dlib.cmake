# The target mdbd_dlib. dlib's own package file asks for the development files of BLAS, LAPACK and
# JPEG, which its Debian package does not bring; the library itself finds what it needs.
if(NOT TARGET mdbd_dlib)
  find_path(DLIB_INCLUDE_DIR dlib/dnn.h REQUIRED)
  find_library(DLIB_LIBRARY dlib REQUIRED)
  add_library(mdbd_dlib INTERFACE IMPORTED)
  target_include_directories(mdbd_dlib SYSTEM INTERFACE ${DLIB_INCLUDE_DIR})
  target_link_libraries(mdbd_dlib INTERFACE ${DLIB_LIBRARY})
endif()
