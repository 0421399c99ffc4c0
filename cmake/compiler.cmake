# The compiler of the presets, and so of what ships: the oldest Clang from 15 on, where there is one, else the default compiler. Clang's
# tick takes a sixth less time than that of GCC 12, and compiling a seventh less. The oldest, since Mesa has
# brought its libraries already, and so that Clangs installed for checks change nothing. CC and CXX name others, and so do
# -DCMAKE_C_COMPILER and -DCMAKE_CXX_COMPILER; a plain `cmake -S .` does not read this file. A build folder keeps what it began with.
if(NOT DEFINED ENV{CXX} AND NOT CMAKE_CXX_COMPILER)
  set(names)
  foreach(version RANGE 15 29)
    list(APPEND names clang++-${version})
  endforeach()
  find_program(UNDERACT_CLANG NAMES ${names})
  if(UNDERACT_CLANG)
    set(CMAKE_CXX_COMPILER ${UNDERACT_CLANG})
    string(REPLACE "clang++-" "clang-" CMAKE_C_COMPILER ${UNDERACT_CLANG})  # of the same package
  endif()
endif()
