#include "app/gui/kit/theme.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QSignalSpy>

namespace underact::gui {
namespace {

void portalSays(ThemeWatcher& watcher, uint scheme, const char* key = "color-scheme") {
  QMetaObject::invokeMethod(&watcher, "portalSettingChanged",
                            Q_ARG(QString, QStringLiteral("org.freedesktop.appearance")),
                            Q_ARG(QString, QString::fromLatin1(key)), Q_ARG(QDBusVariant, QDBusVariant(scheme)));
}

bool windowIsDark() {
  return QApplication::palette().color(QPalette::Window).lightness() < 128;
}

TEST(Theme, BackgroundsAreTheOnesOfTheDesignAndWordsAreReadable) {
  EXPECT_EQ(Theme::light().background, QColor(0xF7, 0xF7, 0xF5));
  EXPECT_EQ(Theme::dark_theme().background, QColor(0x1E, 0x1F, 0x22));
  for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
    const QPalette palette = paletteOf(theme);
    EXPECT_GT(std::abs(theme.ink.lightness() - theme.background.lightness()), 180);
    EXPECT_GT(std::abs(palette.color(QPalette::WindowText).lightness() - palette.color(QPalette::Window).lightness()),
              150);
    EXPECT_GT(std::abs(palette.color(QPalette::ButtonText).lightness() - palette.color(QPalette::Button).lightness()),
              150);
  }
}

TEST(ThemeWatcher, AChoiceHoldsAndIsSaidOnce) {
  ThemeWatcher watcher;
  watcher.choose(ThemeChoice::Light);
  QSignalSpy changed(&watcher, &ThemeWatcher::changed);
  watcher.choose(ThemeChoice::Dark);
  watcher.choose(ThemeChoice::Dark);
  EXPECT_EQ(changed.count(), 1);
  EXPECT_TRUE(watcher.theme().dark);
  EXPECT_TRUE(windowIsDark());
  portalSays(watcher, 2);
  EXPECT_TRUE(watcher.theme().dark);
  EXPECT_EQ(changed.count(), 1);
  watcher.choose(ThemeChoice::Light);
  EXPECT_EQ(changed.count(), 2);
  EXPECT_FALSE(windowIsDark());
  watcher.choose(ThemeChoice::System);
}

TEST(ThemeWatcher, SystemFollowsThePortalAndElseThePalette) {
  ThemeWatcher watcher;
  watcher.choose(ThemeChoice::System);
  const bool palette_dark = watcher.theme().dark;
  QSignalSpy changed(&watcher, &ThemeWatcher::changed);
  portalSays(watcher, palette_dark ? 2 : 1);
  EXPECT_NE(watcher.theme().dark, palette_dark);
  EXPECT_EQ(windowIsDark(), !palette_dark);
  portalSays(watcher, palette_dark ? 2 : 1);
  portalSays(watcher, palette_dark ? 1 : 2, "accent-color");  // not ours
  EXPECT_EQ(changed.count(), 1);
  portalSays(watcher, 0);  // no preference
  EXPECT_EQ(watcher.theme().dark, palette_dark);
  EXPECT_EQ(windowIsDark(), palette_dark);
  EXPECT_EQ(changed.count(), 2);
}

}  // namespace
}  // namespace underact::gui
