# The languages of the window besides English: resources/languages/underact_*.ts, kept by packaging/languages, made into what Qt
# reads and put into the program, so that they are found wherever it is.
file(GLOB texts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/resources/languages/*.ts)
set_source_files_properties(${texts} PROPERTIES OUTPUT_LOCATION ${PROJECT_BINARY_DIR}/languages)
qt_add_lrelease(underact_gui TS_FILES ${texts} QM_FILES_OUTPUT_VARIABLE languages)
# Later formats keep when each file was made, and no two builds would give the same bytes.
qt_add_resources(underact_gui languages PREFIX /languages BASE ${PROJECT_BINARY_DIR}/languages FILES ${languages}
                 OPTIONS --format-version 1)
