# cmake -DMOC=program -DMADE=file -DHEADERS="header;..." -P moc.cmake: the meta-objects of all headers that
# declare one, in one file.
set(text "")
foreach(header IN LISTS HEADERS)
  file(STRINGS ${header} declared REGEX "^ *Q_(OBJECT|GADGET|NAMESPACE)")
  if(declared)
    file(RELATIVE_PATH name ${CMAKE_CURRENT_LIST_DIR}/.. ${header})
    execute_process(COMMAND ${MOC} -f${name} ${header} OUTPUT_VARIABLE made COMMAND_ERROR_IS_FATAL ANY)
    string(APPEND text "${made}")
  endif()
endforeach()
file(WRITE ${MADE} "${text}")
