# The Debian package of the programs with their manual pages and completions: cpack -G DEB, or
# scripts/package. What the programs link to is found by dpkg-shlibdeps.
set(MDBD_MAINTAINER "mdbd maintainers <maintainers@example.org>" CACHE STRING
  "Maintainer named in the Debian package")

set(package_documents ${PROJECT_BINARY_DIR}/documents/package)
string(TIMESTAMP package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH is respected
file(CONFIGURE OUTPUT ${package_documents}/changelog CONTENT
"mdbd (@PROJECT_VERSION@) unstable; urgency=medium

  * Version @PROJECT_VERSION@; CHANGELOG.md of the sources says what is new.

 -- @MDBD_MAINTAINER@  @package_date@
" @ONLY)
file(CONFIGURE OUTPUT ${package_documents}/copyright CONTENT
"mdbd, @PROJECT_DESCRIPTION@

Copyright (C) 2026 the authors of mdbd. The sources name no licence: ask the authors before you pass it on.
" @ONLY)
execute_process(COMMAND gzip -9nf ${package_documents}/changelog COMMAND_ERROR_IS_FATAL ANY)
install(FILES ${package_documents}/changelog.gz ${package_documents}/copyright
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/mdbd COMPONENT programs)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mdbd)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL programs)  # the libraries are static: for building, not for a package
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME mdbd)
set(CPACK_DEBIAN_PROGRAMS_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "Finds the models of a folder that look like a given one, whatever their pose,
scale and format: meshes as OFF, OBJ, PLY and STL, and point clouds. Each is
decomposed into the largest balls that fit inside it, one after the other,
whose radii and contacts are compared.

It needs no training, no display and no network.")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${MDBD_MAINTAINER})
include(CPack)
