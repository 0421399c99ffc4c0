# How a program finds what belongs to it: data, helpers, the Python package. An installed one from its own folder, by relative
# paths (folders.h). One in a build folder, whatever that is called and wherever it lies, from the file underact-places beside
# it, which names the sources and the build folder; it is not installed, and no such path is in a program.
foreach(row IN ITEMS "DATA|${CMAKE_INSTALL_FULL_DATADIR}/underact" "HELPERS|${CMAKE_INSTALL_FULL_LIBEXECDIR}/underact"
                     "PYTHON|${UNDERACT_PYTHON_FOLDER}")
  string(REPLACE "|" ";" row "${row}")
  list(POP_FRONT row what folder)
  get_filename_component(folder ${folder} ABSOLUTE BASE_DIR ${CMAKE_INSTALL_PREFIX})
  file(RELATIVE_PATH UNDERACT_${what}_FROM_PROGRAMS ${CMAKE_INSTALL_FULL_BINDIR} ${folder})
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/folders.h.in ${PROJECT_BINARY_DIR}/generated/underact/folders.h @ONLY)

# Writes it into each folder below this one in which programs are built.
function(underact_write_places folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")
      get_property(binary DIRECTORY ${folder} PROPERTY BINARY_DIR)
      file(CONFIGURE OUTPUT ${binary}/underact-places CONTENT "@PROJECT_SOURCE_DIR@\n@PROJECT_BINARY_DIR@\n" @ONLY)
      break()
    endif()
  endforeach()
  get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(other IN LISTS below)
    underact_write_places(${other})
  endforeach()
endfunction()
