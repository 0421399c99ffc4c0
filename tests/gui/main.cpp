#include <gtest/gtest.h>

#include "app/gui/kit/application.h"
#include "app/gui/view/gl_surface.h"

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);  // first, so that --gtest_list_tests needs no screen
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  QSurfaceFormat::setDefaultFormat(underact::gui::surfaceFormat());
  const underact::gui::Application application(argc, argv);
  return RUN_ALL_TESTS();
}
