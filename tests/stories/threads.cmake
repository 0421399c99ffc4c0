# The stories that TSan runs, and the race it must see among them.
set(shared ${stories})
list(FILTER shared EXCLUDE REGEX "_test.cpp$")
stories_program(threads_stories ${shared} threads_test.cpp planted_race.cpp)
if(NOT XVFB_RUN)
  message(WARNING "xvfb-run is missing: the stories are built, but ctest does not run them.")
  return()
endif()

# What is not built with the sanitizer is not looked into: Qt, VTK, Mesa and what they bring pass things between their threads
# by means that it cannot see.
function(threads_test name)
  add_test(NAME ${name} COMMAND ${XVFB_RUN} -a -s "-screen 0 1920x1200x24" $<TARGET_FILE:threads_stories> ${ARGN})
  set_tests_properties(${name} PROPERTIES TIMEOUT 600 LABELS gui
                       ENVIRONMENT "QT_QPA_PLATFORM=xcb;LIBGL_ALWAYS_SOFTWARE=1;TSAN_OPTIONS=ignore_noninstrumented_modules=1${UNDERACT_SYMBOLIZER}")
endfunction()
threads_test(threads_stories)
threads_test(planted_race_in_window --gtest_also_run_disabled_tests --gtest_filter=PlantedRace.*)
set_tests_properties(planted_race_in_window PROPERTIES PASS_REGULAR_EXPRESSION "data race.*stories/planted_race.cpp")
