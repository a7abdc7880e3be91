# Installs the libraries with their headers and the package that find_package(mdbd) finds. The
# programs install themselves (mdbd_program).
include(CMakePackageConfigHelpers)

set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/mdbd)

# Whoever links the libraries finds the modules where they were installed.
target_link_options(mdbd_features INTERFACE
  "$<INSTALL_INTERFACE:LINKER:-rpath,$<INSTALL_PREFIX>/${mdbd_installed_modules}>")

install(TARGETS mdbd_core mdbd_features mdbd_store mdbd_query EXPORT mdbd
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY features store query DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mdbd
  FILES_MATCHING PATTERN "*.h" PATTERN *_output.h EXCLUDE PATTERN query_arguments.h EXCLUDE PATTERN run_queries.h EXCLUDE)

install(EXPORT mdbd NAMESPACE mdbd:: FILE mdbd-targets.cmake DESTINATION ${package_directory})
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/mdbd-config.cmake.in ${PROJECT_BINARY_DIR}/mdbd-config.cmake
  INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mdbd-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/mdbd-config.cmake
  ${PROJECT_BINARY_DIR}/mdbd-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/flann.cmake
  ${CMAKE_CURRENT_LIST_DIR}/pcl.cmake
  DESTINATION ${package_directory})
