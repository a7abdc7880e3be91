# Every third-party package, in one place. Why each was chosen: docs/dependencies.md.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(SQLite3 3.40 REQUIRED)
find_package(PNG 1.6 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)

include(${CMAKE_CURRENT_LIST_DIR}/flann.cmake)
find_package(OpenMesh REQUIRED)
include(${CMAKE_CURRENT_LIST_DIR}/pcl.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/dlib.cmake)
