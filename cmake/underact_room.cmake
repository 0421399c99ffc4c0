# underact_room(FOLDER [SELDOM] [OF folder ...] [LINKS room ...] [USES library ...] [SHOWS library ...] [WITHOUT folder ...]
#               [PRECOMPILES header ... | LIKE room] [PROGRAM name [IN folder] [COMPONENT name] [STARTS program ...] [OPENS target ...]])
# Makes one static target of the sources of FOLDER and the folders below it, or OF other folders, which are compiled together; WITHOUT:
# those below it that are rooms of their own (all: every one). A room is called as its folder is, without core/, device/ or app/:
# gui/kit, whose target is underact_gui_kit. PRECOMPILES: headers that it reads once; else it has those of the room LIKE which it is
# compiled, of base where none is named. A LINKS that is no target yet is an error, so the order of the calls is the order of the
# architecture. With PROGRAM, main.cpp is left out of the room and becomes the program of that name, installed IN bin, another folder, or
# nowhere. STARTS: other programs that it starts; OPENS: targets that make files which it opens. Whoever builds it has them, too. SELDOM:
# none of it runs at each tick, nor takes long, and it is optimized less; so are all rooms of app/ but that of the Python module.
include_guard()

# GCC 12 finds members of std::function and of Eigen's decompositions "maybe uninitialized" that are not, and, in precompiled headers,
# std::string's and vectors' copies out of bounds or overlapping. Compiled with others, a test's fixture in an unnamed namespace looks to
# it as one in a header. Clang names what the standard library deprecates and uses itself. The next compiler warns of something else: so
# a warning is an error only where CMAKE_COMPILE_WARNING_AS_ERROR says so, as the preset "ci" does. That a name in a function is one that
# a file compiled before it has for itself is none: that file may be new. Each file alone must have no such name.
set(UNDERACT_WARNINGS -Wall -Wextra -Wconversion -Wshadow $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-error=shadow>
                      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-array-bounds -Wno-subobject-linkage -Wno-stringop-overflow
                                                       -Wno-stringop-overread -Wno-restrict>
                      $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>)

# Of what no servo thread runs and nobody waits for: the rooms of app/, those of core that say so, and tests. -O2 takes a fifth more of the
# compiler's time there, and inlining what nobody has called inline a fifth again; no picture is drawn faster, as VTK and Qt do the
# work. From 13 on GCC refuses headers that were precompiled with -O2 unless this loop option, which -O2 sets, is the same.
include(CheckCXXCompilerFlag)
set(UNDERACT_LESS_OPTIMIZED $<$<NOT:$<CONFIG:Debug>>:-O1>)
check_cxx_compiler_flag(-munroll-only-small-loops UNDERACT_HAS_SMALL_LOOPS)
if(UNDERACT_HAS_SMALL_LOOPS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND UNDERACT_LESS_OPTIMIZED $<$<NOT:$<CONFIG:Debug>>:-munroll-only-small-loops>)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  list(APPEND UNDERACT_LESS_OPTIMIZED $<$<NOT:$<CONFIG:Debug>>:-mllvm> $<$<NOT:$<CONFIG:Debug>>:-inline-threshold=5>)
endif()

add_library(underact_flags INTERFACE)
# -ffp-contract=off: the same bits on CPUs with and without fused multiply-add (replay, design.md).
# -fno-tree-slp-vectorize: where it vectorizes straight-line code, GCC 12 takes (double)(float)x for x, so what was rounded
# in order to be a bound, or a rest of known size, is not (tests/core/mesh/on_triangle_test.cpp met it).
target_compile_options(underact_flags INTERFACE -ffp-contract=off $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
target_include_directories(underact_flags INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
if(UNDERACT_SANITIZE)
  target_compile_options(underact_flags INTERFACE -fsanitize=${UNDERACT_SANITIZE} -fno-omit-frame-pointer
                                                  -fno-sanitize-recover=all)
  # A null pointer faults by itself, which ASan reports with its line. Checking for it before each access, and for alignment, is a
  # third of the compiler's time. packaging/soak has UBSan alone with all its checks.
  if(UNDERACT_SANITIZE STREQUAL "address,undefined")
    # Clang's looks also at how a function is called through a pointer, and a maker's library has its own names for what it takes.
    target_compile_options(underact_flags INTERFACE -fno-sanitize=null,alignment,object-size,vptr
                                                    $<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=function>)
  endif()
  target_link_options(underact_flags INTERFACE -fsanitize=${UNDERACT_SANITIZE})
endif()
# Of what includes Boost.Asio. GCC says that its TSan does not know the fences there.
set(UNDERACT_ASIO_OPTIONS)
if(UNDERACT_SANITIZE STREQUAL "thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(UNDERACT_ASIO_OPTIONS -Wno-tsan)
endif()

configure_file(${CMAKE_CURRENT_LIST_DIR}/version.h.in ${PROJECT_BINARY_DIR}/generated/underact/version.h @ONLY)

# The target of a room, or of a folder that is one.
function(underact_target_of room into)
  string(REGEX REPLACE "^(core|device|app)/" "" name ${room})
  string(REPLACE "/" "_" name ${name})
  set(${into} underact_${name} PARENT_SCOPE)
endfunction()

# What Qt's meta-object compiler makes of the headers among SOURCES, those of TARGET that stand in FOLDER, goes through the compiler
# together with its first files: by itself each of forty rooms would read its headers once more for it. Not by AUTOMOC, which reads all
# that the headers include and waits for what the room links: together 55 s of a processor, and our headers have no macro that the
# meta-object compiler must know.
function(underact_moc target folder sources)
  set(headers ${sources})
  list(FILTER headers INCLUDE REGEX "^${PROJECT_SOURCE_DIR}/${folder}/.*\\.h$")
  list(FILTER sources INCLUDE REGEX "^${PROJECT_SOURCE_DIR}/${folder}/.*\\.cpp$")
  list(GET sources 0 first)
  get_source_file_property(group ${first} UNITY_GROUP)
  underact_target_of(${folder} name)
  set(made ${PROJECT_BINARY_DIR}/generated/mocs/${name}.cpp)
  add_custom_command(OUTPUT ${made} DEPENDS ${headers} ${PROJECT_SOURCE_DIR}/cmake/moc.cmake VERBATIM COMMENT "Meta-objects of ${folder}"
                     COMMAND ${CMAKE_COMMAND} -DMOC=$<TARGET_FILE:Qt6::moc> -DMADE=${made} "-DHEADERS=${headers}" -P ${PROJECT_SOURCE_DIR}/cmake/moc.cmake)
  set_source_files_properties(${made} PROPERTIES UNITY_GROUP ${group})
  target_sources(${target} PRIVATE ${made})
endfunction()

function(underact_room folder)
  cmake_parse_arguments(PARSE_ARGV 1 room "SELDOM" "PROGRAM;IN;COMPONENT;LIKE" "OF;LINKS;USES;SHOWS;WITHOUT;STARTS;OPENS;PRECOMPILES")
  if(room_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "underact_room(${folder}): what is ${room_UNPARSED_ARGUMENTS}?")
  endif()
  underact_target_of(${folder} target)
  set(recurse _RECURSE)
  if(room_WITHOUT STREQUAL "all")
    set(recurse)
  endif()
  set(together TOGETHER ${folder})
  if(NOT room_OF)
    set(room_OF ${folder})
    set(together)
  endif()
  set(sources)
  foreach(part IN LISTS room_OF)
    file(GLOB${recurse} found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${part}/*.cpp ${PROJECT_SOURCE_DIR}/${part}/*.h)
    list(APPEND sources ${found})
  endforeach()
  list(REMOVE_ITEM sources ${PROJECT_SOURCE_DIR}/${folder}/main.cpp)
  foreach(other IN LISTS room_WITHOUT)
    list(FILTER sources EXCLUDE REGEX "/${folder}/${other}/")
  endforeach()
  if(NOT room_LIKE)
    set(room_LIKE base)
  endif()
  underact_target_of(${room_LIKE} like)
  set(public PUBLIC)
  if(NOT sources)
    add_library(${target} INTERFACE)
    set(public INTERFACE)
  else()
    add_library(${target} STATIC ${sources})
    set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
    if(room_PRECOMPILES)
      underact_compile(${target} HEADERS ${room_PRECOMPILES})
      set(like ${target})
    else()
      underact_compile(${target} LIKE ${like} ${together})
    endif()
    if(room_SELDOM OR (folder MATCHES "^app/" AND NOT folder STREQUAL "app/bindings"))
      target_compile_options(${target} PRIVATE ${UNDERACT_LESS_OPTIMIZED})
    endif()
    if(folder MATCHES "^app/gui/")
      foreach(part IN LISTS room_OF)
        underact_moc(${target} ${part} "${sources}")
      endforeach()
    endif()
    target_compile_options(${target} PRIVATE ${UNDERACT_WARNINGS})
    target_link_libraries(${target} PRIVATE ${room_USES})
  endif()
  target_link_libraries(${target} ${public} underact_flags ${room_SHOWS})
  foreach(link IN LISTS room_LINKS)
    underact_target_of(${link} below)
    if(NOT TARGET ${below})
      message(FATAL_ERROR "${folder} links ${link}, which stands below it or nowhere: links point upwards.")
    endif()
    target_link_libraries(${target} ${public} ${below})
  endforeach()
  if(room_PROGRAM)
    add_executable(${room_PROGRAM} ${PROJECT_SOURCE_DIR}/${folder}/main.cpp)
    target_compile_options(${room_PROGRAM} PRIVATE ${UNDERACT_LESS_OPTIMIZED} ${UNDERACT_WARNINGS})
    target_link_libraries(${room_PROGRAM} PRIVATE ${target})
    underact_compile(${room_PROGRAM} LIKE ${like})
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

# underact_feature(FOLDER [LINKS room ...]): a room of the window that does one thing, and has a feature.cpp that gives its row,
# NAMEFeature(). Without its line, or its folder, the window does without it.
set(UNDERACT_FEATURES)
set(UNDERACT_FEATURE_LINKS gui/feature)
function(underact_feature folder)
  cmake_parse_arguments(PARSE_ARGV 1 feature "" "" "LINKS")
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${folder}/feature.cpp)
    message(FATAL_ERROR "${folder} has no feature.cpp.")
  endif()
  string(REGEX REPLACE "^app/" "" room ${folder})
  set(UNDERACT_FEATURES ${UNDERACT_FEATURES} ${room} PARENT_SCOPE)
  set(UNDERACT_FEATURE_LINKS ${UNDERACT_FEATURE_LINKS} ${feature_LINKS} PARENT_SCOPE)
endfunction()

# underact_features(OUT): makes them, and writes the table of them, in their order; OUT: the source that has it. They are compiled
# together: apart, each of 34 would instantiate what all of them have in common, a third of the compiler's time for them. That none
# includes another, or what its own line does not link, is tested.
function(underact_features out)
  list(TRANSFORM UNDERACT_FEATURES PREPEND app/ OUTPUT_VARIABLE folders)
  list(REMOVE_DUPLICATES UNDERACT_FEATURE_LINKS)
  underact_room(app/gui/features OF ${folders} LINKS ${UNDERACT_FEATURE_LINKS} LIKE gui/view)
  set(UNDERACT_FEATURE_DECLARATIONS)
  set(UNDERACT_FEATURE_ROWS)
  foreach(room IN LISTS UNDERACT_FEATURES)
    underact_target_of(${room} target)
    add_library(${target} ALIAS underact_gui_features)
    get_filename_component(name ${room} NAME)
    string(REGEX MATCHALL "_[a-z]" humps ${name})
    foreach(hump IN LISTS humps)  # second_arm: secondArmFeature()
      string(TOUPPER ${hump} upper)
      string(REPLACE "_" "" upper ${upper})
      string(REPLACE ${hump} ${upper} name ${name})
    endforeach()
    string(APPEND UNDERACT_FEATURE_DECLARATIONS "FeatureRow ${name}Feature();\n")
    string(APPEND UNDERACT_FEATURE_ROWS "          ${name}Feature(),\n")
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/features.cpp.in ${PROJECT_BINARY_DIR}/generated/underact/features.cpp @ONLY)
  set(${out} ${PROJECT_BINARY_DIR}/generated/underact/features.cpp PARENT_SCOPE)
endfunction()
