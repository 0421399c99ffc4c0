#include <gtest/gtest.h>

#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>
#include <clocale>

#include "app/gui/kit/application.h"
#include "app/gui/view/gl_surface.h"

// As the program's own main prepares it, but with settings and files of nobody: no test reads or writes the user's.
int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);  // first, so that --gtest_list_tests needs no screen
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  const QTemporaryDir own;
  for (const char* folder : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "UNDERACT_CACHE_DIR"})
    qputenv(folder, own.path().toUtf8());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, own.path());
  QSurfaceFormat::setDefaultFormat(underact::gui::surfaceFormat());
  QApplication::setOrganizationName("Underact");
  QApplication::setApplicationName("underact-rooms");
  const underact::gui::Application application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  QLocale::setDefault(QLocale::c());
  return RUN_ALL_TESTS();
}
