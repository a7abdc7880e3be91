# Everything that all targets share: language, warnings, floating point, sanitizers.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(MDBD_CCACHE ccache)
if(MDBD_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${MDBD_CCACHE})
endif()

add_library(mdbd_settings INTERFACE)
target_compile_features(mdbd_settings INTERFACE cxx_std_20)
# Contraction to fused multiply-add would make results depend on the target machine, so it is off
# everywhere. For the same reason nothing here is built for the "native" processor.
target_compile_options(mdbd_settings INTERFACE
  $<BUILD_INTERFACE:-ffp-contract=off;-Wall;-Wextra;-Wpedantic;-Wshadow>
  # GCC 12 warns of overlapping copies inside std::string (its bug 105651).
  $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>>
  $<$<BOOL:${MDBD_STRICT}>:-Werror>)
if(MDBD_SANITIZE)
  set(MDBD_SANITIZERS -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_compile_options(mdbd_settings INTERFACE ${MDBD_SANITIZERS})
  # With AddressSanitizer Eigen aligns memory by itself, and what PCL's libraries took from malloc
  # would be freed in another way. The sanitizer's malloc is aligned, too.
  target_compile_definitions(mdbd_settings INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
  target_link_options(mdbd_settings INTERFACE ${MDBD_SANITIZERS})
endif()

include(GNUInstallDirs)

# A library of one room. Headers are included by their path from the top of the project
# ("features/core/ball.h"); installed, the same tree stands below include/mdbd.
function(mdbd_library name)
  add_library(mdbd_${name} STATIC ${ARGN})
  add_library(mdbd::${name} ALIAS mdbd_${name})
  set_target_properties(mdbd_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(mdbd_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/mdbd>)
  target_link_libraries(mdbd_${name} PRIVATE $<BUILD_INTERFACE:mdbd_settings>)
  target_compile_features(mdbd_${name} PUBLIC cxx_std_20)
endfunction()

# Sources with loops over lanes (features/core/vectorised.h). Without errno and traps square roots and
# selections are single instructions; no result changes.
function(mdbd_vectorised)
  set_source_files_properties(${ARGN} PROPERTIES
    COMPILE_OPTIONS "-O3;-fno-math-errno;-fno-trapping-math")
endfunction()

# A program of the product: its main is thin, the room's library does the work.
function(mdbd_program name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE mdbd_settings)
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()
