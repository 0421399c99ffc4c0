#include <gtest/gtest.h>

#include <QApplication>
#include <QScreen>
#include <QScrollArea>
#include <map>

#include "app/gui/window/features.h"
#include "tests/stories/access_desk.h"
#include "tests/stories/language_desk.h"
#include "tests/support/contrast.h"

namespace underact::gui::test {
namespace {

using underact::test::contrast;

/// What is wider than its place and scrolls sideways, or would have to.
QStringList scrolledSideways(const QWidget& panel) {
  QStringList wide;
  for (const QScrollArea* area : panel.findChildren<QScrollArea*>()) {
    if (area->isVisible() && area->widget() != nullptr && area->widget()->width() > area->viewport()->width() + 1)
      wide << area->parentWidget()->objectName() + " is wider than its place";
  }
  return wide;
}

/// To be looked at by people.
void keep(const QImage& picture, const QString& name) {
  EXPECT_TRUE(picture.save(QString(UNDERACT_BINARY) + "/pictures/access_" + name + ".png"));
}

/// Pixels that are another colour now, and one that stands out from the ground at 3:1 or more (WCAG 2.1, 1.4.11).
int standOut(const QImage& before, const QImage& now, const QColor& ground) {
  int count = 0;
  for (int y = 0; y < now.height(); ++y) {
    for (int x = 0; x < now.width(); ++x) {
      const QColor is = now.pixelColor(x, y);
      count += before.pixelColor(x, y) != is && contrast(is, ground) >= 3.0 ? 1 : 0;
    }
  }
  return count;
}

/// Widgets of a kind are drawn alike: its class, and what the style sheet tells it by.
std::string kindOf(const QWidget& widget) {
  const QString role = widget.property("role").toString();
  return (widget.metaObject()->className() + (role.isEmpty() ? QString() : " " + role)).toStdString();
}

/// The part of the window that a widget takes up.
QImage seenOf(Story& story, const QWidget& widget) {
  QCoreApplication::processEvents();
  return story.window().grab(QRect(widget.mapTo(&story.window(), QPoint()), widget.size())).toImage();
}

/// How much of each kind of widget changes where it gets the focus, in pixels.
std::map<std::string, int> focusSeen(Story& story) {
  std::map<std::string, int> seen;
  for (const PanelRow& row : panelsOf(features())) {
    bringPanel(story, row.key);
    for (QWidget* widget : reachable(*story.find(QString("panel.") + row.key))) {
      if (seen.contains(kindOf(*widget)) || widget->visibleRegion().isEmpty()) continue;
      story.view().setFocus(Qt::OtherFocusReason);
      const QImage before = seenOf(story, *widget);
      widget->setFocus(Qt::TabFocusReason);
      const QColor ground = widget->palette().color(QPalette::Window);
      seen[kindOf(*widget)] = standOut(before, seenOf(story, *widget), ground);
    }
  }
  return seen;
}

}  // namespace

TEST(AccessLookStory, TextOfTwiceTheSizeIsCutInNoPanel) {
  const LargeText large;
  Story story("20_scara", {.size = {1920, 1080}});
  story.perform("session.start");
  story.run(500);
  QStringList cut;
  for (const PanelRow& row : panelsOf(features())) {
    bringPanel(story, row.key);
    QWidget& dock = *story.find(QString("dock.") + row.key);
    cut << cutWords(dock) << scrolledSideways(dock);
    keep(story.picture(), row.key);
  }
  cut << cutWords(*story.find("toolbar")) << cutWords(*story.find("status"));
  cut.removeDuplicates();
  EXPECT_EQ(cut.join('\n').toStdString(), "");
}

TEST(AccessLookStory, NorInADialogOrALesson) {
  const LargeText large;
  Story story("02_sphere", {.size = {1920, 1080}});
  QStringList cut;
  for (const char* name : {"help.keys", "help.about", "live.address", "servo.check", "help.figures",
                           "registration.open", "identify.open", "help.guide"}) {
    EXPECT_TRUE(story.perform(name)) << name;
    story.settle();
    for (QWidget* widget : QApplication::topLevelWidgets()) {
      if (widget == &story.window() || !widget->isVisible()) continue;
      cut << cutWords(*widget);
      EXPECT_LE(widget->height(), widget->screen()->size().height()) << name;
      keep(widget->grab().toImage(), name);
      widget->close();
    }
  }
  ASSERT_TRUE(story.perform("lesson.start", QString("01_frames")));
  story.settle();
  cut << cutWords(*story.find("dock.lessons"));
  keep(story.picture(), "lesson");
  cut.removeDuplicates();
  EXPECT_EQ(cut.join('\n').toStdString(), "");
}

TEST(AccessLookStory, TheFocusIsSeenInEveryKindOfWidgetLightAndDark) {
  const int flash_ms = QApplication::cursorFlashTime();
  QApplication::setCursorFlashTime(0);
  for (const char* theme : {"light", "dark"}) {
    Story story("20_scara");
    story.perform(QString("view.theme.") + theme);
    story.key(Qt::Key_Tab);       // from now on the keyboard is in use
    constexpr int kSide_px = 12;  // of the smallest mark that counts
    const std::map<std::string, int> seen = focusSeen(story);
    bringPanel(story, "scenes");
    story.find("panel.scenes.list")->setFocus(Qt::TabFocusReason);
    keep(story.window().grab().toImage(), QString("focus_") + theme);
    EXPECT_GT(seen.size(), 10U);
    for (const auto& [kind, pixels] : seen) EXPECT_GE(pixels, 2 * kSide_px) << kind << ", " << theme;
  }
  QApplication::setCursorFlashTime(flash_ms);
}

TEST(AccessLookStory, TheViewShowsThatItHasTheKeys) {
  Story story("02_sphere");
  story.view().clearFocus();
  story.settle();
  const QImage before = story.view().picture();
  story.key(Qt::Key_F2);
  story.settle();
  ASSERT_TRUE(story.view().hasFocus());
  const QColor ground = before.pixelColor(before.width() / 2, 4);
  EXPECT_GT(standOut(before, story.view().picture(), ground), story.view().width());
}

}  // namespace underact::gui::test
