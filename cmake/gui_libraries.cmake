# Qt 6 for the window, VTK 9 for its pictures. Debian's VTK is built with Qt 5, so VTK's own Qt module must not be linked:
# only what draws is asked for, and app/gui/view brings its pictures into a Qt 6 widget.
find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets OpenGLWidgets PrintSupport DBus Test)
# Esc is heard while the window is busy, by a connection of its own. Qt's plug-in for X11 has brought the library.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  pkg_check_modules(XCB_XINPUT REQUIRED IMPORTED_TARGET xcb xcb-xinput)
  set(UNDERACT_XCB PkgConfig::XCB_XINPUT)
endif()
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel FiltersCore RenderingCore RenderingOpenGL2)
