#include <gtest/gtest.h>

#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <map>

#include "app/gui/kit/page_view.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/view/picture.h"
#include "tests/stories/mesh_desk.h"
#include "tests/stories/picture_difference.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

QListWidgetItem* itemOf(QListWidget* list, const QString& path) {
  for (int row = 0; row < list->count(); ++row) {
    if (list->item(row)->data(Qt::UserRole).toString() == path) return list->item(row);
  }
  return nullptr;
}

void clickItem(Story& story, QListWidget* list, QListWidgetItem* item) {
  list->scrollToItem(item);
  story.click(list->viewport(), list->visualItemRect(item).center());
}

}  // namespace

TEST(ScenesStory, AClickInTheListOpensEachShippedScene) {
  Story story("02_sphere");
  auto* list = story.find<QListWidget>("panel.scenes.list");
  story.perform("session.start");
  const QStringList files =
      QDir(QString(UNDERACT_SOURCE) + "/scenes").entryList({"[0-9]*.json"}, QDir::Files, QDir::Name);
  ASSERT_GE(files.size(), 9);
  for (const QString& file : files) {
    const QString path = QString(UNDERACT_SOURCE) + "/scenes/" + file;
    QListWidgetItem* item = itemOf(list, path);
    ASSERT_NE(item, nullptr) << file.toStdString();
    const QString title = item->text();
    const bool was_open = story.window().document().path() == path;
    const std::uint64_t before = story.host().revision();
    clickItem(story, list, item);
    ASSERT_TRUE(waitForMeshes(story)) << file.toStdString();
    EXPECT_EQ(QString::fromStdString(story.host().scene().title), title);
    EXPECT_EQ(story.host().revision(), before + (was_open ? 0 : 1)) << file.toStdString();
    story.run(1000);
    EXPECT_EQ(story.snapshot().revision, story.host().revision());
    EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
    EXPECT_EQ(story.snapshot().report.held.size(), story.host().scene().constraints.size());
    EXPECT_TRUE(story.window().windowTitle().startsWith(title));
  }
}

TEST(ScenesStory, TheKeyboardChoosesAndReturnOpens) {
  Story story("02_sphere");
  auto* list = story.find<QListWidget>("panel.scenes.list");
  story.perform("scenes.find");
  EXPECT_TRUE(story.find("panel.scenes.filter")->hasFocus());
  story.key(Qt::Key_Tab);
  if (!list->hasFocus()) story.key(Qt::Key_Tab);
  ASSERT_TRUE(list->hasFocus());
  story.key(Qt::Key_Down);
  EXPECT_EQ(story.host().scene().title, "Sphere");  // looking is not opening
  story.key(Qt::Key_Return);
  EXPECT_NE(story.host().scene().title, "Sphere");
}

TEST(ScenesStory, FromTheFilterDownGoesToTheFirstHitAndEnterOpensIt) {
  Story story("39_iiwa_pose");  // at the end of the list
  auto* const list = story.find<QListWidget>("panel.scenes.list");
  story.perform("scenes.find");
  for (const Qt::Key letter : {Qt::Key_S, Qt::Key_P, Qt::Key_H, Qt::Key_E, Qt::Key_R, Qt::Key_E}) story.key(letter);
  story.settle();
  EXPECT_TRUE(list->viewport()->rect().contains(list->visualItemRect(itemOf(list, shippedScene("02_sphere")))));
  story.key(Qt::Key_Down);
  EXPECT_TRUE(list->hasFocus());
  EXPECT_EQ(list->currentItem(), itemOf(list, shippedScene("02_sphere")));
  story.perform("scenes.find");
  story.key(Qt::Key_S), story.key(Qt::Key_P), story.key(Qt::Key_H);
  story.key(Qt::Key_Return);
  EXPECT_EQ(story.host().scene().title, "Sphere");
}

TEST(ScenesStory, TheFilterLeavesWhatFits) {
  Story story("02_sphere");
  auto* list = story.find<QListWidget>("panel.scenes.list");
  auto* filter = story.find<QLineEdit>("panel.scenes.filter");
  filter->setFocus();
  for (const Qt::Key letter : {Qt::Key_P, Qt::Key_L, Qt::Key_A, Qt::Key_N, Qt::Key_E}) story.key(letter);
  EXPECT_EQ(filter->text().toLower(), "plane");
  EXPECT_FALSE(itemOf(list, shippedScene("04_plane"))->isHidden());
  EXPECT_TRUE(itemOf(list, shippedScene("01_point"))->isHidden());
}

TEST(ScenesStory, ASceneNamedAtTheStartIsSeenInTheList) {
  for (const char* name : {"21_puma_560", "27_bracket", "01_point"}) {
    Story story("", {.shown = false});
    story.window().show();
    ASSERT_TRUE(story.perform("scene.open", shippedScene(name)));  // as main() does, before anything is laid out
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&story.window()));
    ASSERT_TRUE(waitForMeshes(story));
    story.settle();
    const auto* list = story.find<QListWidget>("panel.scenes.list");
    ASSERT_NE(list->currentItem(), nullptr) << name;
    const QRect item = list->visualItemRect(list->currentItem());
    EXPECT_GE(item.top(), 0) << name;
    EXPECT_LE(item.bottom(), list->viewport()->height()) << name;
  }
}

TEST(ScenesStory, TheSelectedSceneIsDescribedWithWhatToFeelToTryAndItsEquation) {
  Story story("05_circle");
  const auto* page = story.find<PageView>("panel.scenes.about");
  const QString text = page->toPlainText();
  const scene::Teaching teaching = scene::teachingOf(shippedScene("05_circle").toStdString()).value();
  EXPECT_TRUE(text.contains(QString::fromStdString(story.host().scene().about)));
  EXPECT_TRUE(text.contains("Feel: " + QString::fromStdString(teaching.feel)));
  EXPECT_TRUE(text.contains("Try: " + QString::fromStdString(teaching.try_this)));
  EXPECT_TRUE(text.contains("Equation: "));
  EXPECT_FALSE(text.contains("$")) << text.toStdString();  // it is drawn, not shown as it was written
}

TEST(ScenesStory, TheGroupsStandInTeachingOrderEachWithItsScenes) {
  Story story("02_sphere");
  const auto* list = story.find<QListWidget>("panel.scenes.list");
  QStringList headings;
  std::map<QString, int> scenes;
  for (int row = 0; row < list->count(); ++row) {
    if (list->item(row)->data(Qt::UserRole).isNull())
      headings << list->item(row)->text();
    else
      ++scenes[headings.last()];
  }
  EXPECT_EQ(headings, (QStringList{"Shapes", "Walls", "Orientation", "Virtual robots", "Meshes", "Curves", "Stability",
                                   "Other arms"}));
  EXPECT_EQ(scenes["Walls"], 3);
  EXPECT_EQ(scenes["Orientation"], 2);
  EXPECT_EQ(scenes["Virtual robots"], 8);
  EXPECT_EQ(scenes["Meshes"], 3);
}

TEST(ScenesStory, ASavedSceneKeepsWhatItTeaches) {
  Story story("09_wall");
  const QString path = temporaryFile("wall.json");
  ASSERT_TRUE(story.perform("gains.set", "kp", "x", 0.3));
  ASSERT_TRUE(story.perform("scene.save_as", path));
  EXPECT_EQ(scene::teachingOf(path.toStdString()), scene::teachingOf(shippedScene("09_wall").toStdString()));
}

TEST(ScenesStory, TheSmallPicturesAreNotOld) {
  const QString folder = QString(UNDERACT_SOURCE) + "/resources/pictures/scenes/";
  for (const SceneEntry& entry : shippedScenes()) {
    for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
      const QString name = QFileInfo(entry.path).completeBaseName() + (theme.dark ? "_dark.png" : ".png");
      const Result<QImage> now = smallPicture(entry.path.toStdString(), theme);
      ASSERT_TRUE(now) << name.toStdString();
      if (qEnvironmentVariableIsSet("UNDERACT_UPDATE_PICTURES")) {
        QDir().mkpath(folder);
        EXPECT_TRUE(now.value().save(folder + name));
      }
      EXPECT_LT(worstBlockDifference(now.value(), QImage(folder + name)), kTolerance) << name.toStdString();
      EXPECT_FALSE(scenePicture(entry.path, theme.dark).isEmpty()) << name.toStdString();
    }
  }
}

TEST(ScenesStory, AnotherSceneHasAnotherPicture) {  // the comparison sees what matters
  const QImage point = smallPicture(shippedScene("01_point").toStdString(), Theme::light()).value();
  const QImage sphere = smallPicture(shippedScene("02_sphere").toStdString(), Theme::light()).value();
  EXPECT_GT(worstBlockDifference(point, sphere), 2.0 * kTolerance);
}

}  // namespace underact::gui::test
