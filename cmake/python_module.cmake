# The core as a Python module, underact._core: what app/python/underact/arm.py and others beside it call. Off in the programs' own
# builds; -DUNDERACT_PYTHON=ON turns it on, and so does pip (pyproject.toml), which sets SKBUILD. pybind11 is pip's, or Debian's pybind11-dev.
include_guard()

if(UNDERACT_PYTHON)
  set(PYBIND11_FINDPYTHON ON)
  if(NOT SKBUILD AND NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3)  # the system's, as of all tests: a second one on the PATH seldom has numpy
  endif()
  find_package(Python COMPONENTS Interpreter Development.Module)
  if(Python_FOUND)
    find_package(pybind11 CONFIG)
  endif()
  if(NOT pybind11_FOUND AND SKBUILD)
    message(FATAL_ERROR "Python's headers, or pybind11, were not found. packaging/install-deps python brings the headers, pip pybind11.")
  elseif(NOT pybind11_FOUND)
    message(STATUS "Python's headers, or pybind11, are not installed: the Python module is left out (python3-dev, pybind11-dev).")
    set(UNDERACT_PYTHON OFF)
  endif()
endif()

# The module is linked of the programs' own objects, so that it costs no second compilation, and the programs are compiled as without
# it. They are position-independent as of an executable, as Debian's compiler makes them: they lack no more than data of other shared
# libraries. That of the standard library is in the module, which has it statically; rooms that use data of others are compiled as for a
# library. Where a compiler makes other objects, -DCMAKE_POSITION_INDEPENDENT_CODE=ON compiles all as for a library.
function(underact_for_a_library)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE -fPIC -fvisibility=hidden)
    set_target_properties(${target} PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)  # which are not compiled so
  endforeach()
endfunction()

# underact_python_module(NAME FOLDER): the module of FOLDER's main.cpp and its room, and beside it, in the build folder's python/underact,
# links to the package's other files, so that PYTHONPATH=build/release/python has all of it.
function(underact_python_module name folder)
  underact_target_of(${folder} room)
  add_library(${name} MODULE ${PROJECT_SOURCE_DIR}/${folder}/main.cpp)
  target_link_libraries(${name} PRIVATE ${room} pybind11::module)
  target_compile_options(${name} PRIVATE ${UNDERACT_WARNINGS} -fvisibility=hidden)
  pybind11_extension(${name})
  set(names ${PROJECT_BINARY_DIR}/generated/${name}.map)
  file(CONFIGURE OUTPUT ${names} CONTENT "{ global: PyInit_${name}; local: *; };\n")
  target_link_options(${name} PRIVATE -static-libstdc++ -static-libgcc -Wl,--version-script=${names})
  set(package ${PROJECT_BINARY_DIR}/python/underact)
  set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${package} UNITY_BUILD OFF)
  file(MAKE_DIRECTORY ${package})
  file(GLOB parts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/app/python/underact/*)
  list(FILTER parts EXCLUDE REGEX "__pycache__$")
  foreach(part IN LISTS parts)
    get_filename_component(part_name ${part} NAME)
    file(CREATE_LINK ${part} ${package}/${part_name} SYMBOLIC)
  endforeach()
  install(TARGETS ${name} LIBRARY DESTINATION underact COMPONENT module EXCLUDE_FROM_ALL)
  install(TARGETS underact-mesh-reader RUNTIME DESTINATION underact COMPONENT module EXCLUDE_FROM_ALL)  # as wheels have it
endfunction()
