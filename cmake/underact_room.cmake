# underact_room(FOLDER [LINKS room ...] [USES library ...] [SHOWS library ...] [WITHOUT folder ...]
#               [PRECOMPILES header ...] [PROGRAM name [IN folder] [COMPONENT name] [STARTS program ...] [OPENS target ...]])
# Makes one static target, underact_<last part of FOLDER>, of the sources of FOLDER and the folders below it; WITHOUT: those of
# them that are rooms of their own. PRECOMPILES: headers that it reads once, in place of those of core/base. A LINKS
# that is no target yet is an error, so the order of the calls is the order of the architecture. With PROGRAM, main.cpp
# is left out of the room and becomes the program of that name, installed IN bin, another folder, or nowhere. STARTS: other
# programs that it starts; OPENS: targets that make files which it opens. Whoever builds it has them, too.
include_guard()

# GCC 12 finds members of std::function and of Eigen's decompositions "maybe uninitialized" that are not, and, in precompiled
# headers, std::string's copies out of bounds. Compiled with others, a test's fixture in an unnamed namespace looks to it as one in
# a header. The next compiler warns of something else: so a warning is an error only where CMAKE_COMPILE_WARNING_AS_ERROR says so,
# as the preset "ci" does.
set(UNDERACT_WARNINGS -Wall -Wextra -Wconversion -Wshadow
                      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-array-bounds -Wno-subobject-linkage>)

add_library(underact_flags INTERFACE)
# -ffp-contract=off: the same bits on CPUs with and without fused multiply-add (replay, design.md).
# -fno-tree-slp-vectorize: where it vectorizes straight-line code, GCC 12 takes (double)(float)x for x, so what was rounded
# in order to be a bound, or a rest of known size, is not (tests/core/mesh/on_triangle_test.cpp met it).
target_compile_options(underact_flags INTERFACE -ffp-contract=off $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
target_include_directories(underact_flags INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
if(UNDERACT_SANITIZE)
  target_compile_options(underact_flags INTERFACE -fsanitize=${UNDERACT_SANITIZE} -fno-omit-frame-pointer
                                                  -fno-sanitize-recover=all)
  target_link_options(underact_flags INTERFACE -fsanitize=${UNDERACT_SANITIZE})
endif()

configure_file(${CMAKE_CURRENT_LIST_DIR}/version.h.in ${PROJECT_BINARY_DIR}/generated/underact/version.h @ONLY)

function(underact_room folder)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "PROGRAM;IN;COMPONENT" "LINKS;USES;SHOWS;WITHOUT;STARTS;OPENS;PRECOMPILES")
  if(room_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "underact_room(${folder}): what is ${room_UNPARSED_ARGUMENTS}?")
  endif()
  get_filename_component(name ${folder} NAME)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp ${PROJECT_SOURCE_DIR}/${folder}/*.h
                                              ${PROJECT_SOURCE_DIR}/${folder}/*.qrc)
  list(REMOVE_ITEM sources ${PROJECT_SOURCE_DIR}/${folder}/main.cpp)
  foreach(other IN LISTS room_WITHOUT)
    list(FILTER sources EXCLUDE REGEX "/${folder}/${other}/")
  endforeach()
  add_library(underact_${name} STATIC ${sources})
  set_target_properties(underact_${name} PROPERTIES LINKER_LANGUAGE CXX)
  if(room_PRECOMPILES)
    underact_compile(underact_${name} HEADERS ${room_PRECOMPILES})
  else()
    underact_compile(underact_${name} LIKE underact_base)
  endif()
  target_compile_options(underact_${name} PRIVATE ${UNDERACT_WARNINGS})
  target_link_libraries(underact_${name} PUBLIC underact_flags ${room_SHOWS} PRIVATE ${room_USES})
  foreach(link IN LISTS room_LINKS)
    if(NOT TARGET underact_${link})
      message(FATAL_ERROR "${folder} links ${link}, which stands below it or nowhere: links point upwards.")
    endif()
    target_link_libraries(underact_${name} PUBLIC underact_${link})
  endforeach()
  if(room_PROGRAM)
    add_executable(${room_PROGRAM} ${PROJECT_SOURCE_DIR}/${folder}/main.cpp)
    target_compile_options(${room_PROGRAM} PRIVATE ${UNDERACT_WARNINGS})
    target_link_libraries(${room_PROGRAM} PRIVATE underact_${name})
    underact_compile(${room_PROGRAM} LIKE underact_${name})
    if(room_STARTS OR room_OPENS)
      add_dependencies(${room_PROGRAM} ${room_STARTS} ${room_OPENS})
    endif()
    if(NOT room_IN)
      set(room_IN ${CMAKE_INSTALL_BINDIR})
    endif()
    if(NOT room_IN STREQUAL "nowhere")
      install(TARGETS ${room_PROGRAM} RUNTIME DESTINATION ${room_IN} COMPONENT ${room_COMPONENT})
    endif()
  endif()
endfunction()
