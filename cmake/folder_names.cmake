# Refuses folders whose names CMake, Ninja, a list of folders or the linker's options take for something else, before any of them does so
# with a message that names neither the folder nor a way out: ; ends an element of a list, * ? [ are patterns, : and , separate, and so on.
# Blanks, brackets ( ), quotes ' and letters of any language are well. packaging/install-deps has the same characters.
include_guard()

foreach(folder IN ITEMS CMAKE_CURRENT_SOURCE_DIR CMAKE_CURRENT_BINARY_DIR)
  string(REGEX REPLACE "^[A-Za-z]:/" "/" plain "${${folder}}")  # of Windows
  if(plain MATCHES "[];\"#$*?<>=:,`|\\[]")
    message(FATAL_ERROR "The folder ${${folder}} cannot be built in: its name contains ${CMAKE_MATCH_0}, which the tools of the build take "
      "for something else. Rename it, or move the sources to another folder: letters, digits, blanks and ( ) ' - _ . are allowed.")
  endif()
endforeach()
