# Qt 6 for the window, VTK 9 for its pictures. Debian's VTK is built with Qt 5, so VTK's own Qt module must not be linked:
# only what draws is asked for, and app/gui/view brings its pictures into a Qt 6 widget.
find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets OpenGLWidgets DBus Test)
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel FiltersCore RenderingCore RenderingOpenGL2)
