# Every third-party package, in one place. Why each was chosen: docs/dependencies.md.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(SQLite3 3.40 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)

# FLANN's own package files pull in HDF5 and MPI, which its templates do not need.
find_path(FLANN_INCLUDE_DIR flann/flann.hpp REQUIRED)
find_library(FLANN_LIBRARY flann_cpp REQUIRED)
find_library(LZ4_LIBRARY lz4 REQUIRED)
add_library(mdbd_flann INTERFACE IMPORTED)
target_include_directories(mdbd_flann SYSTEM INTERFACE ${FLANN_INCLUDE_DIR})
target_link_libraries(mdbd_flann INTERFACE ${FLANN_LIBRARY} ${LZ4_LIBRARY})

find_package(OpenMesh REQUIRED)
