#include <gtest/gtest.h>

#include <QApplication>

#include "app/gui/view/gl_surface.h"

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);  // first, so that --gtest_list_tests needs no screen
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  QSurfaceFormat::setDefaultFormat(underact::gui::surfaceFormat());
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
