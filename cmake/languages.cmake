# The languages of the window besides English: resources/languages/underact_*.ts, kept by packaging/languages, made into what Qt
# reads and put into the program, so that they are found wherever it is.
file(GLOB texts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/resources/languages/*.ts)
# By the tool itself: Qt's CMake functions for it come with Designer, libclang and sixteen packages more.
find_program(UNDERACT_LRELEASE lrelease HINTS ${QT6_INSTALL_PREFIX}/${QT6_INSTALL_BINS} ${QT6_INSTALL_PREFIX}/${QT6_INSTALL_LIBEXECS} REQUIRED)
set(languages)
foreach(text IN LISTS texts)
  get_filename_component(name ${text} NAME_WE)
  set(language ${PROJECT_BINARY_DIR}/languages/${name}.qm)
  add_custom_command(OUTPUT ${language} DEPENDS ${text} VERBATIM COMMENT "Translating: ${name}"
                     COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/languages
                     COMMAND ${UNDERACT_LRELEASE} -silent ${text} -qm ${language})
  list(APPEND languages ${language})
endforeach()
# Later formats keep when each file was made, and no two builds would give the same bytes.
qt_add_resources(underact_gui_model languages PREFIX /languages BASE ${PROJECT_BINARY_DIR}/languages FILES ${languages}
                 OPTIONS --format-version 1)
# The words themselves, in which the palette finds a command by its name in another language.
qt_add_resources(underact_gui_model words PREFIX /words BASE ${PROJECT_SOURCE_DIR}/resources/languages FILES ${texts} OPTIONS --format-version 1)
