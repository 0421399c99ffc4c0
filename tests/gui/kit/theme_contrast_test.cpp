#include <gtest/gtest.h>

#include "app/gui/kit/theme.h"
#include "tests/support/contrast.h"

namespace underact::gui::test {

using underact::test::contrast;

TEST(Theme, TextHasTheContrastOfWcagAaInEveryPalette) {
  for (const Theme& theme :
       {Theme::light(), Theme::dark_theme(), Theme::contrasting(false), Theme::contrasting(true)}) {
    const QPalette palette = paletteOf(theme);
    const std::string name = std::string(theme.dark ? "dark" : "light") + (theme.high_contrast ? " contrasting" : "");
    const double min = theme.high_contrast ? 7.0 : 4.5;  // AAA for the far end of the room
    EXPECT_GE(contrast(theme.ink, theme.background), min) << name;
    struct Pair {
      QPalette::ColorRole text, ground;
    };
    for (const Pair& pair :
         {Pair{QPalette::WindowText, QPalette::Window}, Pair{QPalette::Text, QPalette::Base},
          Pair{QPalette::ButtonText, QPalette::Button}, Pair{QPalette::ToolTipText, QPalette::ToolTipBase},
          Pair{QPalette::Text, QPalette::AlternateBase}})
      EXPECT_GE(contrast(palette.color(pair.text), palette.color(pair.ground)), min) << name << " " << pair.text;
    EXPECT_GE(contrast(palette.color(QPalette::Link), palette.color(QPalette::Base)), 4.5) << name;
    EXPECT_GE(contrast(mixed(theme.background, theme.ink, 0.68), palette.color(QPalette::Window)), 4.5)
        << name << ": quiet labels";
  }
}

TEST(Theme, WhatIsDrawnStandsOutFromTheGround) {
  for (const bool dark : {false, true}) {
    const Theme theme = Theme::contrasting(dark);
    for (const QColor& colour :
         {theme.constraint, theme.target, theme.orientation, theme.position, theme.force, theme.force_limited,
          theme.virtual_robot, theme.motion, theme.quiet, theme.x_axis, theme.y_axis, theme.z_axis})
      EXPECT_GE(contrast(colour, theme.background), 3.0) << colour.name().toStdString() << (dark ? " dark" : " light");
  }
}

}  // namespace underact::gui::test
