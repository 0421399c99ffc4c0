# The arm files of resources/arms as text inside core/arm, so that a program finds them wherever it is installed; a person
# edits the file, and the next build has it.
file(GLOB arm_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/resources/arms/*.json)
set(UNDERACT_ARM_FILES "")
foreach(arm_file IN LISTS arm_files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${arm_file})
  file(READ ${arm_file} text)
  string(APPEND UNDERACT_ARM_FILES "    R\"arm(${text})arm\",\n")
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/arm_files.h.in ${PROJECT_BINARY_DIR}/generated/underact/arm_files.h @ONLY)
