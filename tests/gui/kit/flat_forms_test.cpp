#include "app/gui/kit/flat_forms.h"

#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>

#include "app/gui/kit/contrast.h"
#include "app/gui/kit/theme.h"

namespace underact::gui {
namespace {

const Theme kThemes[] = {Theme::light(), Theme::dark_theme(), Theme::contrasting(false), Theme::contrasting(true)};

QStyleOptionSlider barOf(const Theme& theme, int position) {
  QStyleOptionSlider bar;
  bar.palette = paletteOf(theme);
  bar.state = QStyle::State_Enabled;
  bar.orientation = Qt::Vertical;
  bar.rect = QRect(0, 0, 12, 200);
  bar.minimum = 0;
  bar.maximum = 300;
  bar.pageStep = 100;
  bar.sliderPosition = position;
  return bar;
}

template <class Draw>
QImage drawn(const QSize& size, const Theme& theme, const Draw& draw) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(paletteOf(theme).color(QPalette::Window));
  QPainter painter(&image);
  draw(painter);
  return image;
}

double maxContrast(const QImage& image, const QColor& ground) {
  double max = 1.0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) max = std::max(max, contrastOf(image.pixelColor(x, y), ground));
  }
  return max;
}

TEST(FlatForms, AScrollBarIsAllHandleAndWayWithoutButtons) {
  for (const int position : {0, 150, 300}) {
    const QStyleOptionSlider bar = barOf(Theme::light(), position);
    const QRect handle = partOfScrollBar(bar, QStyle::SC_ScrollBarSlider, 24);
    EXPECT_EQ(handle.height(), 50);  // a quarter of the whole is seen
    EXPECT_EQ(handle.top(), position / 2);
    const QRect before = partOfScrollBar(bar, QStyle::SC_ScrollBarSubPage, 24);
    const QRect after = partOfScrollBar(bar, QStyle::SC_ScrollBarAddPage, 24);
    EXPECT_EQ(before.height() + handle.height() + after.height(), 200);
    EXPECT_TRUE(partOfScrollBar(bar, QStyle::SC_ScrollBarAddLine, 24).isEmpty());
  }
  QStyleOptionSlider long_one = barOf(Theme::light(), 0);
  long_one.maximum = 1'000'000;
  EXPECT_EQ(partOfScrollBar(long_one, QStyle::SC_ScrollBarSlider, 24).height(), 24);  // can still be taken
}

TEST(FlatForms, WhatIsThereIsSeenInEachTheme) {
  for (const Theme& theme : kThemes) {
    const QPalette palette = paletteOf(theme);
    const QColor window = palette.color(QPalette::Window);
    QStyleOptionButton box;
    box.palette = palette;
    box.state = QStyle::State_Enabled | QStyle::State_Off;
    box.rect = QRect(2, 2, 14, 14);
    const auto draws = [&](QPainter& painter) { drawCheckBox(box, painter); };
    const QImage unticked = drawn({18, 18}, theme, draws);
    EXPECT_GE(contrastOf(unticked.pixelColor(9, 2), window), 2.9) << theme.background.name().toStdString();
    box.state = QStyle::State_Enabled | QStyle::State_On;
    const QImage ticked = drawn({18, 18}, theme, draws);
    EXPECT_GE(maxContrast(ticked.copy(4, 4, 10, 10), ticked.pixelColor(4, 4)), 2.5) << "the tick in its box";
    const QStyleOptionSlider bar = barOf(theme, 150);
    const QImage scroll = drawn({12, 200}, theme, [&](QPainter& painter) {
      drawScrollBar(bar, partOfScrollBar(bar, QStyle::SC_ScrollBarSlider, 24), painter);
    });
    EXPECT_GE(contrastOf(scroll.pixelColor(6, 100), window), 2.9);
    EXPECT_EQ(scroll.pixelColor(6, 20), window);
    QStyleOptionSlider slider = barOf(theme, 150);
    slider.orientation = Qt::Horizontal;
    slider.rect = QRect(0, 0, 120, 16);
    const QImage sliding = drawn(
        {120, 16}, theme, [&](QPainter& painter) { drawSlider(slider, slider.rect, QRect(52, 0, 16, 16), painter); });
    EXPECT_GE(contrastOf(sliding.pixelColor(20, 8), window), 2.9) << "up to the handle";
    EXPECT_NE(sliding.pixelColor(100, 8), sliding.pixelColor(20, 8));
  }
}

}  // namespace
}  // namespace underact::gui
