#include <gtest/gtest.h>

#include <QFile>
#include <QLocale>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <clocale>

#include "app/gui/kit/accessible_widgets.h"
#include "app/gui/kit/application.h"
#include "app/gui/kit/focus_style.h"

// The same preparations as the program's own main, but with settings of nobody: no story reads or writes the user's.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);  // before Qt: the build lists the tests where there is no screen
  QTemporaryDir settings;
  qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
  qputenv("XDG_DATA_HOME", settings.path().toUtf8());  // faults are kept there
  // Recordings go among the documents, unless a story says where.
  QFile folders(settings.filePath("user-dirs.dirs"));
  if (folders.open(QIODevice::WriteOnly)) {
    folders.write("XDG_DOCUMENTS_DIR=\"" + settings.filePath("documents").toUtf8() + "\"\n");
    folders.close();
  }
  qputenv("UNDERACT_DATA_DIR", UNDERACT_SOURCE);
  qputenv("UNDERACT_CLI", UNDERACT_CLI);
  qputenv("UNDERACT_MESH_READER", UNDERACT_MESH_READER);
  qputenv("UNDERACT_SESSION_READER", UNDERACT_SESSION_READER);
  qputenv("UNDERACT_CACHE_DIR", settings.filePath("meshes").toUtf8());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setOrganizationName("Underact");
  QApplication::setApplicationName("underact-stories");
  underact::gui::Application application(argc, argv);
  QApplication::setStyle(new underact::gui::FocusStyle);
  underact::gui::makeWidgetsAccessible();
  std::setlocale(LC_NUMERIC, "C");
  QLocale::setDefault(QLocale::c());
  return RUN_ALL_TESTS();
}
