#include "app/gui/kit/fit_screen.h"

#include <gtest/gtest.h>

#include <QDialog>
#include <QScreen>

namespace underact::gui {

TEST(FitScreen, WindowsAndTheirFramesAreWithinWhatThePanelsLeave) {
  const QRect default_value(0, 0, 1280, 800), small(900, 700, 400, 300);
  for (const auto& [window, available, fits] :
       {std::tuple{default_value, QRect(0, 0, 1920, 1040), QRect(1, 37, 1280, 800)},
        {default_value, QRect(0, 0, 1366, 728), QRect(1, 37, 1280, 690)},
        {default_value, QRect(0, 0, 960, 500), QRect(1, 37, 958, 462)},  // 1920 x 1080 at 200 %
        {default_value, QRect(0, 24, 800, 496), QRect(1, 61, 798, 458)},
        {small, QRect(64, 0, 1302, 768), QRect(900, 467, 400, 300)}})  // remembered from a larger screen
    EXPECT_EQ(fitted(window, available, QMargins(1, 37, 1, 1)), fits) << available.width();
  QDialog dialog;
  dialog.setMinimumSize(3000, 300);
  dialog.show();
  EXPECT_LT(dialog.width(), dialog.screen()->availableGeometry().width());
}

}  // namespace underact::gui
