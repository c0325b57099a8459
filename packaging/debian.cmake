# Packages for Debian: the program, the editor, and the libraries for those who build on them.  cmake --workflow --preset package

set(RINCEAU_PACKAGER "The Rinceau authors <rinceau@localhost>" CACHE STRING "Who answers for the packages: Name <address>")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The Rinceau authors")
set(CPACK_PACKAGE_CONTACT "${RINCEAU_PACKAGER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # or it stands above each package's own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program dev)
if(TARGET rinceau-editor)
  list(APPEND CPACK_COMPONENTS_ALL editor)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)  # of the packages of one version
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME rinceau)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "rinceau-editor, inkscape")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "inverse procedural modelling of vector art
Rinceau reads a vector drawing (SVG), finds the L-system behind it - which
elements are copies of each other, in which rows, rings and hierarchies they
stand - and draws the same picture back from the rules. Rules can be edited,
varied and exported to other programs, and grow new ornament: arrangements by
example, dense aggregates, and patterns on surfaces.
.
This package holds the program for the command line and its extension for
Inkscape.")

set(CPACK_DEBIAN_EDITOR_PACKAGE_NAME rinceau-editor)
set(CPACK_DEBIAN_EDITOR_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_EDITOR_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_EDITOR_PACKAGE_RECOMMENDS rinceau)
set(CPACK_DEBIAN_EDITOR_DESCRIPTION "editor for drawings and the rules behind them
Rinceau reads a vector drawing (SVG), finds the L-system behind it, and draws
the same picture back from the rules.
.
This package holds the editor, which shows a drawing beside its rules: every
number can be dragged, elements have handles on the canvas, and what was found
grows new ornament.")

# What rinceauConfig.cmake looks for.
set(CPACK_DEBIAN_DEV_PACKAGE_NAME librinceau-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libtinyxml2-dev, zlib1g-dev, libpng-dev, librsvg2-dev, libcairo2-dev, \
libpolyclipping-dev, libtinyobjloader-dev, libtinygltf-dev, nlohmann-json3-dev, pkg-config")
set(CPACK_DEBIAN_DEV_DESCRIPTION "inverse procedural modelling of vector art - development files
Rinceau reads a vector drawing (SVG), finds the L-system behind it, and draws
the same picture back from the rules.
.
This package holds the static libraries, their headers, and what CMake needs
for find_package(rinceau).")

# What Debian wants to read about each package.
set(papers ${CMAKE_CURRENT_BINARY_DIR}/papers)
file(MAKE_DIRECTORY ${papers})
execute_process(COMMAND date --utc --rfc-email --date ${release_date} OUTPUT_VARIABLE release_day
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(package_version ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
file(CONFIGURE OUTPUT ${papers}/changelog.Debian @ONLY CONTENT [[
rinceau (@package_version@) unstable; urgency=medium

  * Version @PROJECT_VERSION@; its changes are in changelog.gz of the package rinceau.

 -- @RINCEAU_PACKAGER@  @release_day@
]])
file(COPY_FILE ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${papers}/changelog)
foreach(paper IN ITEMS changelog changelog.Debian)
  execute_process(COMMAND ${RINCEAU_GZIP} -9nkf ${papers}/${paper} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
install(FILES ${papers}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/rinceau COMPONENT program)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper_case)
  set(papers_folder ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper_case}_PACKAGE_NAME})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION ${papers_folder} COMPONENT ${component})
  install(FILES ${papers}/changelog.Debian.gz DESTINATION ${papers_folder} COMPONENT ${component})
endforeach()

include(CPack)
