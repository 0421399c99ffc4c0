#include "app/gui/kit/focus_style.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLayout>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include "app/gui/kit/contrast.h"
#include "app/gui/kit/theme.h"

namespace underact::gui {
namespace {

/// The style and the palette of the program, for as long as a test looks.
struct Dressed {
  explicit Dressed(const Theme& theme) : palette(paletteOf(theme)) {
    QApplication::setStyle(new FocusStyle);
    QApplication::setPalette(palette);
  }
  ~Dressed() {
    QApplication::setStyle("Fusion");
    QApplication::setPalette(QPalette());
  }
  QPalette palette;
};

TEST(FocusStyle, AMenuHasAnEdgeThatIsSeenInEachTheme) {
  for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
    const Dressed dressed(theme);
    QMenu menu;
    menu.addAction("Open");
    menu.resize(menu.sizeHint());
    const QImage picture = menu.grab().toImage();
    for (const QPoint at : {QPoint(0, picture.height() / 2), QPoint(picture.width() - 1, picture.height() / 2),
                            QPoint(picture.width() / 2, 0), QPoint(picture.width() / 2, picture.height() - 1)})
      EXPECT_GE(contrastOf(picture.pixelColor(at), dressed.palette.color(QPalette::Window)), 2.9)
          << at.x() << ' ' << at.y();
  }
}

TEST(FocusStyle, TheIconsOfMessageBoxesAreFlatPaddedAndOfAnInkForTheirGround) {
  for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
    const Dressed dressed(theme);
    for (const QMessageBox::Icon icon :
         {QMessageBox::Question, QMessageBox::Information, QMessageBox::Warning, QMessageBox::Critical}) {
      QMessageBox box(icon, "Title", "What has happened.", QMessageBox::Save | QMessageBox::Discard);
      box.setStyleSheet("QLabel { color: red; }");  // the window has one, too
      box.setInformativeText("More of it.");
      box.show();
      const QImage picture = box.iconPixmap().toImage();
      ASSERT_FALSE(picture.isNull());
      double most = 1.0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
          const QColor colour = picture.pixelColor(x, y);
          const bool is_rim =
              std::min({x, y, picture.width() - 1 - x, picture.height() - 1 - y}) < picture.width() / 16;
          EXPECT_TRUE(!is_rim || colour.alpha() == 0) << x << ' ' << y;
          if (colour.alpha() == 255) most = std::max(most, contrastOf(colour, dressed.palette.color(QPalette::Window)));
        }
      }
      EXPECT_GE(most, 3.0);
      EXPECT_GE(box.layout()->contentsMargins().left(), 16);
      for (const QAbstractButton* button : box.buttons()) EXPECT_TRUE(button->icon().isNull());
    }
  }
}

}  // namespace
}  // namespace underact::gui
