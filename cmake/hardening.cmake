# What makes a mistake that is left in a released program harder to use, as Debian's own packages have it (dpkg-buildflags,
# hardening=+all), and the same bytes whatever folder it is built in. underact_flags: what every room takes. Programs that may lie anywhere in memory are
# Debian's compiler's own choice; tests/packaging looks at all of it in the programs.
if(UNDERACT_SANITIZE OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux" OR CMAKE_BUILD_TYPE STREQUAL "Debug")
  return()
endif()
target_compile_options(underact_flags INTERFACE
  -fstack-protector-strong -fstack-clash-protection -Wformat -Werror=format-security
  $<$<STREQUAL:${CMAKE_SYSTEM_PROCESSOR},x86_64>:-fcf-protection>
  -ffile-prefix-map=${PROJECT_BINARY_DIR}=build -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
target_compile_definitions(underact_flags INTERFACE _FORTIFY_SOURCE=2)
target_link_options(underact_flags INTERFACE -Wl,-z,relro -Wl,-z,now -Wl,--as-needed)
