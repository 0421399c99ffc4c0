# How the compiler gets our files. Reading headers is most of what compiling costs here, so what nearly all include is read once
# (precompiled), and the files of a folder go through the compiler together. The sources know nothing of either: each compiles by
# itself, as -DCMAKE_UNITY_BUILD=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON has it, and names in unnamed namespaces differ within a
# folder (tests/architecture/hidden_names.py). So a new file can only be wrong itself, wherever the border of a unit then falls.
include_guard()

if(UNDERACT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(UNDERACT_CCACHE_PROGRAM ccache)
  if(UNDERACT_CCACHE_PROGRAM)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_CURRENT_LIST_DIR}/with_ccache ${UNDERACT_CCACHE_PROGRAM})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
    elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")  # else a precompiled header of another checkout is out of date in this
      add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-Xclang -fno-pch-timestamp>")
    endif()
  endif()
endif()

# GCC looks for what it can free whenever its memory has doubled, and goes through all the precompiled headers for it: 7 to 16 % of its time,
# to save a tenth of about 1 GB.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:--param ggc-min-expand=300 --param ggc-min-heapsize=262144>")
endif()

option(CMAKE_UNITY_BUILD "Compile the files of a folder together" ON)

set(UNDERACT_COMMON_HEADERS
    <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <mutex> <optional> <ostream>
    <span> <string> <string_view> <thread> <utility> <variant> <vector> <Eigen/Core> <Eigen/Geometry> <boost/lockfree/spsc_queue.hpp>)
set(UNDERACT_WIDGET_HEADERS
    ${UNDERACT_COMMON_HEADERS}
    <QAction> <QApplication> <QBoxLayout> <QCheckBox> <QComboBox> <QDialog> <QDir> <QEvent> <QFileDialog> <QFileInfo> <QFormLayout>
    <QGridLayout> <QHeaderView> <QJsonObject> <QLabel> <QLineEdit> <QList> <QMainWindow> <QMenu> <QMessageBox> <QPainter>
    <QProgressBar> <QPushButton> <QScrollArea> <QSettings> <QSignalBlocker> <QSlider> <QString> <QTableWidget> <QTimer> <QToolButton>)
set(UNDERACT_WINDOW_HEADERS
    ${UNDERACT_WIDGET_HEADERS}
    <vtkActor.h> <vtkNew.h> <vtkPolyData.h> <vtkSmartPointer.h>
    <core/scene/description.h> <core/scene/edit.h> <core/servo/host.h> <core/servo/snapshot.h>)  # ours that nearly all of it includes

# underact_compile(TARGET [HEADERS header ...] [LIKE target] [TOGETHER name]): of the files of TARGET, those of a folder together, at
# most forty at a time (twenty took a fifth longer), with TOGETHER those of all its folders, in units of that name; with HEADERS
# precompiled, or with those of another target.
function(underact_compile target)
  cmake_parse_arguments(PARSE_ARGV 1 compile "" "LIKE;TOGETHER" "HEADERS")
  if(compile_LIKE)
    target_precompile_headers(${target} REUSE_FROM ${compile_LIKE})
  elseif(compile_HEADERS)
    target_precompile_headers(${target} PRIVATE ${compile_HEADERS})
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(folders)
  foreach(source IN LISTS sources)
    get_filename_component(source ${source} ABSOLUTE)
    get_filename_component(folder ${source} DIRECTORY)
    if(compile_TOGETHER)
      set(folder ${PROJECT_SOURCE_DIR}/${compile_TOGETHER})
    endif()
    list(APPEND folders "${folder}")
    list(APPEND "files of ${folder}" ${source})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    list(SORT "files of ${folder}")
    list(LENGTH "files of ${folder}" count)
    math(EXPR units "(${count} + 39) / 40")
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${folder})
    string(MAKE_C_IDENTIFIER "${name}" name)
    set(index 0)
    foreach(source IN LISTS "files of ${folder}")
      math(EXPR unit "${index} * ${units} / ${count}")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${name}_${unit})
      math(EXPR index "${index} + 1")
    endforeach()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
