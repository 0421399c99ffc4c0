#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QTextBrowser>
#include <QToolTip>

#include "tests/stories/session_desk.h"

// Words of others that look like HTML and name a picture. The application makes all labels plain; this looks at each
// place of the window to which such words have come, so that a new one that shows them in another way is found.
namespace underact::gui::test {
namespace {

const QString kHostile = R"(R&D <img src="x.png"> <b>bold</b> [*])";
const QByteArray kQuoted = QByteArray(R"("R&D <img src=\"x.png\"> <b>bold</b> [*]")");

/// Number of places that say it, each of them looked at.
int placesOf(QWidget& window) {
  int places = 0;
  const auto says = [&places](const QString& text) {
    places += text.contains("<img") ? 1 : 0;
    return text.contains("<img");
  };
  const auto look_at_label = [&says](QLabel* label) {
    if (label == nullptr || !says(label->text())) return;
    label->ensurePolished();
    EXPECT_EQ(label->textFormat(), Qt::PlainText) << label->objectName().toStdString() << label->text().toStdString();
    EXPECT_TRUE(label->buddy() == nullptr || !label->text().contains("R&D"));
  };
  const auto look_at_tip = [&](const QString& tip) {
    if (!says(tip)) return;
    QToolTip::showText(window.mapToGlobal(QPoint(1, 1)), tip, &window);
    for (QWidget* const shown : QApplication::topLevelWidgets())
      if (shown->inherits("QTipLabel")) look_at_label(qobject_cast<QLabel*>(shown));
    QToolTip::hideText();
  };
  const auto look_at_button = [&says](const QString& text) {
    if (says(text)) EXPECT_FALSE(QString(text).remove("&&").contains("&")) << text.toStdString();
  };
  for (QWidget* const widget : QApplication::allWidgets()) {
    look_at_tip(widget->toolTip());
    if (!widget->inherits("QTipLabel")) look_at_label(qobject_cast<QLabel*>(widget));
    if (const auto* const button = qobject_cast<QAbstractButton*>(widget)) look_at_button(button->text());
    for (const QAction* const action : widget->actions()) look_at_button(action->text());
    const auto* const view = qobject_cast<QAbstractItemView*>(widget);
    for (int row = 0; view != nullptr && view->model() != nullptr && row < view->model()->rowCount(); ++row) {
      says(view->model()->index(row, 0).data().toString());
      look_at_tip(view->model()->index(row, 0).data(Qt::ToolTipRole).toString());
    }
    if (const auto* const page = qobject_cast<QTextBrowser*>(widget))
      EXPECT_FALSE(page->toHtml().contains("<img src=\"x.png\"")) << page->objectName().toStdString();
  }
  return places;
}

/// With the words in place of each @.
QByteArray inserted(QByteArray text) {
  return text.replace("@", kQuoted);
}

void openAllPanels(Story& story) {
  for (auto* const dock : story.window().findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    story.settle(20);
  }
  story.run(50);
}

TEST(ForeignWordsStory, OfSceneLessonAndSessionAreTextInEveryPanel) {
  Desk desk;
  Story& story = *desk.story;
  desk.session(30, kHostile);
  ASSERT_TRUE(desk.listed(1));
  const QString scene = temporaryFile("R&D <img src=b>.json", inserted(R"({"underact_scene": 1, "title": @, "about": @,
      "constraints": [{"name": @, "type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 50},
      {"name": "b <img src=a>", "type": "line", "point_mm": [0, 0, 0], "direction": [1, 0, 0]}]})"));
  ASSERT_TRUE(story.perform("scene.open", scene));
  ASSERT_TRUE(QTest::qWaitFor([&] { return story.window().document().path() == scene; }, kLong_ms));
  openAllPanels(story);
  EXPECT_TRUE(story.window().windowTitle().startsWith(QString(kHostile).replace("[*]", "[*][*]")));
  EXPECT_GE(placesOf(story.window()), 8);
  const QByteArray lesson = inserted(R"({"underact_lesson": 1, "title": @, "about": @, "steps": [{"title": @, "text": @,
      "scene": "SCENE", "checks": [{"question": @, "choices": [@, "no"], "right": 1},
      {"question": "?", "answer": 1, "within": 0, "unit": @}]}]})");
  ASSERT_TRUE(
      story.perform("lesson.start", temporaryFile("lesson.json", QByteArray(lesson).replace("SCENE", scene.toUtf8()))));
  openAllPanels(story);
  EXPECT_GE(placesOf(story.window()), 12);
}

TEST(ForeignWordsStory, OfABrokenSceneAreTextInItsDialog) {
  Story story("02_sphere");
  story.perform("scene.open", temporaryFile("broken <img src=a>.json", "{\"underact_scene\": 1, " + kQuoted + ": 1}"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return story.window().findChild<QWidget*>("dialog.problems.table") != nullptr; },
                              kLong_ms));
  EXPECT_GE(placesOf(story.window()), 1);
}

}  // namespace
}  // namespace underact::gui::test
