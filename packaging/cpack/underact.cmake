# Packages for other systems, from a finished build, by cpack alone:
#   UNDERACT_BUILD=$PWD/build/release cpack --config packaging/cpack/underact.cmake -G RPM
# The folder comes through the environment: cpack reads this file before it sets what its option -D says.
# RPM makes what the system it is run on can install: build it there. NSIS (Windows) and DragNDrop (macOS) are written after
# CPack's manual and have never been installed anywhere: the program itself has not been built on either.
# Debian's packages and the portable bundle have their own ways.
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
set(UNDERACT_BUILD "$ENV{UNDERACT_BUILD}")
if(NOT UNDERACT_BUILD)
  set(UNDERACT_BUILD "${root}/build/release")
endif()
if(NOT EXISTS "${UNDERACT_BUILD}/generated/underact/version.h")
  message(FATAL_ERROR "There is no finished build in ${UNDERACT_BUILD}. Name one: UNDERACT_BUILD=FOLDER cpack ...")
endif()
file(STRINGS "${UNDERACT_BUILD}/generated/underact/version.h" line REGEX "kVersion")
string(REGEX REPLACE ".*\"([0-9]+)\\.([0-9]+)\\.([0-9]+)\".*" "\\1;\\2;\\3" parts "${line}")
list(GET parts 0 CPACK_PACKAGE_VERSION_MAJOR)
list(GET parts 1 CPACK_PACKAGE_VERSION_MINOR)
list(GET parts 2 CPACK_PACKAGE_VERSION_PATCH)
string(REPLACE ";" "." CPACK_PACKAGE_VERSION "${parts}")

set(CPACK_PACKAGE_NAME underact)
set(CPACK_PACKAGE_VENDOR "The Underact authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Feel geometry through a small haptic arm, and see what you feel")
set(CPACK_PACKAGE_DESCRIPTION_FILE "${root}/packaging/cpack/description.txt")
set(CPACK_RESOURCE_FILE_LICENSE "${root}/LICENSE")
set(CPACK_RESOURCE_FILE_README "${root}/packaging/cpack/description.txt")
set(CPACK_PACKAGE_FILE_NAME "underact-${CPACK_PACKAGE_VERSION}")
set(CPACK_PACKAGE_EXECUTABLES underact Underact)
set(CPACK_PACKAGE_INSTALL_DIRECTORY Underact)
set(CPACK_CMAKE_GENERATOR Ninja)
set(CPACK_INSTALL_CMAKE_PROJECTS "${UNDERACT_BUILD};Underact;ALL;/")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# What differs from kind to kind: CPack reads it when it knows which.
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_CURRENT_LIST_DIR}/generators.cmake")
