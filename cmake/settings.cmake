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
  # The sanitizer calls dlopen in the program's place, which then searches its own RUNPATH; the
  # older RPATH of a program is for all.
  target_link_options(mdbd_settings INTERFACE ${MDBD_SANITIZERS} LINKER:--disable-new-dtags)
endif()

include(GNUInstallDirs)

# Where modules are (mdbd_module), in the build tree and installed. The folder has the version in
# its name, since a module and the program that loads it must be of one build.
set(mdbd_built_modules ${PROJECT_BINARY_DIR}/modules)
set(mdbd_installed_modules ${CMAKE_INSTALL_LIBDIR}/mdbd-${PROJECT_VERSION})
set(CMAKE_BUILD_RPATH ${mdbd_built_modules})
file(RELATIVE_PATH programs_to_modules
  ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_PREFIX}/${mdbd_installed_modules})
set(CMAKE_INSTALL_RPATH $ORIGIN/${programs_to_modules})
add_custom_target(mdbd_modules)

# A library of one room. Headers are included by their path from the top of the project
# ("features/core/ball.h"); installed, the same tree stands below include/mdbd.
function(mdbd_library name)
  add_library(mdbd_${name} STATIC ${ARGN})
  add_library(mdbd::${name} ALIAS mdbd_${name})
  set_target_properties(mdbd_${name} PROPERTIES EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)  # modules link them, too
  target_include_directories(mdbd_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/mdbd>)
  target_link_libraries(mdbd_${name} PRIVATE $<BUILD_INTERFACE:mdbd_settings>)
  target_compile_features(mdbd_${name} PUBLIC cxx_std_20)
endfunction()

# A shared library that programs load when they first need it (features/modules/module.h):
# mdbd_module(mdbd_cad SOURCES … LIBRARIES …).
function(mdbd_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_library(${name} MODULE ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${mdbd_built_modules} INSTALL_RPATH "")
  target_link_libraries(${name} PRIVATE mdbd_settings ${arg_LIBRARIES})
  install(TARGETS ${name} LIBRARY DESTINATION ${mdbd_installed_modules} COMPONENT programs)
  add_dependencies(mdbd_modules ${name})
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
  add_dependencies(${name} mdbd_modules)
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
  mdbd_documents(${name})
endfunction()

# The manual page and the completions of a program, which it writes itself.
function(mdbd_documents name)
  set(folder ${PROJECT_BINARY_DIR}/documents)
  set(man ${folder}/${name}.1.gz)
  set(bash ${folder}/bash/${name})
  set(zsh ${folder}/zsh/_${name})
  set(fish ${folder}/fish/${name}.fish)
  file(MAKE_DIRECTORY ${folder}/bash ${folder}/zsh ${folder}/fish)
  add_custom_command(OUTPUT ${man} ${bash} ${zsh} ${fish}
    COMMAND $<TARGET_FILE:${name}> --man | gzip -9n > ${man}
    COMMAND $<TARGET_FILE:${name}> --completion bash > ${bash}
    COMMAND $<TARGET_FILE:${name}> --completion zsh > ${zsh}
    COMMAND $<TARGET_FILE:${name}> --completion fish > ${fish}
    DEPENDS ${name}
    COMMENT "Writing the manual page and completions of ${name}"
    VERBATIM)
  add_custom_target(${name}-documents ALL DEPENDS ${man} ${bash} ${zsh} ${fish})
  install(FILES ${man} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
    COMPONENT programs)
  install(FILES ${bash} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    COMPONENT programs)
  install(FILES ${zsh} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
    COMPONENT programs)
  install(FILES ${fish} DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
    COMPONENT programs)
endfunction()
