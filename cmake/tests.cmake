include(Catch)

# One test program of a room: mdbd_test(store SOURCES … LIBRARIES …). Each Catch2 case becomes a
# ctest case named ROOM/CASE.
function(mdbd_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(test_${name} ${arg_SOURCES})
  target_link_libraries(test_${name} PRIVATE mdbd_test_main Catch2::Catch2 mdbd_settings ${arg_LIBRARIES})
  add_dependencies(test_${name} mdbd_modules)
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  catch_discover_tests(test_${name} TEST_PREFIX "${name}/" PROPERTIES TIMEOUT 120)
endfunction()
