#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QTableWidget>
#include <optional>
#include <set>

#include "app/gui/kit/number_box.h"
#include "app/gui/kit/page_view.h"
#include "app/gui/kit/words.h"
#include "app/gui/window/features.h"
#include "core/scene/read.h"
#include "tests/core/scene/scene_support.h"
#include "tests/stories/language_desk.h"
#include "tests/stories/story.h"
#include "tests/support/pattern.h"

namespace underact::gui::test {
namespace {

/// All panels, one after the other; what each is seen to cut.
QStringList cutInPanels(Story& story) {
  QStringList cut;
  for (const PanelRow& row : panelsOf(features())) {
    EXPECT_TRUE(story.perform(QString("dock.") + row.key, true)) << row.key;
    story.run(1);
    story.settle();
    cut << cutWords(*story.find(QString("dock.") + row.key));
    story.savePicture(QString("german_") + row.key);
  }
  cut << cutWords(*story.find("toolbar")) << cutWords(*story.find("status"));
  return cut;
}

/// What some scenes have, and others not.
QStringList cutInScenes(Story& story) {
  QStringList cut;
  for (const char* scene : {"14_circle_influence", "20_scara", "09_wall"}) {
    EXPECT_TRUE(story.perform("scene.open", shippedScene(scene)));
    story.run(250);
    for (const char* panel : {"feel", "shape", "robot", "scenes"}) {
      story.perform(QString("dock.") + panel, false);  // and to the front
      story.perform(QString("dock.") + panel, true);
      story.settle();
      cut << cutWords(*story.find(QString("dock.") + panel));
    }
    story.savePicture(QString("german_") + scene);
  }
  return cut;
}

/// What opens a window of its own, and what that is seen to cut.
QStringList cutInDialogs(Story& story) {
  QStringList cut;
  for (const char* name : {"help.keys", "help.about", "live.address", "servo.check", "help.figures",
                           "registration.open", "identify.open", "help.guide", "language.en"}) {
    EXPECT_TRUE(story.perform(name)) << name;
    story.settle();
    int windows = 0;
    for (QWidget* widget : QApplication::topLevelWidgets()) {
      if (widget == &story.window() || !widget->isVisible()) continue;
      ++windows;
      cut << cutWords(*widget);
      widget->grab().save(QString(UNDERACT_BINARY) + "/pictures/german_" + name + ".png");
      widget->close();
    }
    EXPECT_GT(windows, 0) << name;
    story.settle();
  }
  return cut;
}

QByteArray savedAfterAnEdit() {
  Story story("02_sphere");
  EXPECT_TRUE(story.perform("gains.set", "kp", "x", 0.35));
  const QString path = temporaryFile("tuned.json");
  EXPECT_TRUE(story.perform("scene.save_as", path));
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  return file.readAll();
}

/// The text with each of its numbers, words and keys, one at a time, made what it must not be.
std::vector<std::string> spoiled(const std::string& text) {
  std::vector<std::string> made;
  for (const underact::test::PatternMatch& piece :
       underact::test::matchesOf(R"re("[^"]*"|-?\d[\d.e+-]*|true|false)re", text)) {
    for (const char* instead : {"-1e9", "0", "\"nonsense\"", "\"\"", "[]", "{}", "null", "[1, 2, 3]", "", "1e-300"})
      made.push_back(std::string(text).replace(piece.at, piece.groups[0].size(), instead));
  }
  return made;
}

}  // namespace

TEST(LanguageStory, InGermanNoTextIsLeftOutAndNoneIsCut) {
  const German german;
  Story story("12_line_pid");
  story.perform("session.start");
  story.run(500);
  QStringList cut = cutInPanels(story);
  EXPECT_TRUE(story.perform("lesson.start", QString("01_frames")));
  story.settle();
  cut << cutWords(*story.find("dock.lessons"));
  story.perform("lesson.leave");
  cut << cutInScenes(story);
  for (const char* name : {"help.welcome", "help.tour"}) {
    EXPECT_TRUE(story.perform(name)) << name;
    story.run(250);
    story.settle();
    cut << cutWords(story.window());
    story.savePicture(QString("german_") + name);
  }
  EXPECT_TRUE(story.perform("compare.on", true));
  story.run(500);
  story.settle();
  cut << cutWords(*story.find("compare")) << cutWords(*story.find("compare.views"));
  story.savePicture("german_compare");
  story.perform("compare.on", false);
  cut << cutInDialogs(story);
  cut.removeDuplicates();
  EXPECT_EQ(cut.join('\n').toStdString(), "");
  EXPECT_EQ(german.missing().join('\n').toStdString(), "");
}

TEST(LanguageStory, TheChoiceIsKeptAndTheNextWindowSpeaksIt) {
  {
    Story story("02_sphere");
    EXPECT_EQ(chosenLanguage(), "system");
    EXPECT_TRUE(story.window().actions().find("language.system")->isChecked());
    ASSERT_TRUE(story.perform("language.de"));
    story.settle();
    auto* box = story.find<QMessageBox>("dialog.language");
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(box->text(), "The language changes when you next start Underact.");
    box->accept();
    EXPECT_EQ(story.window().menuBar()->actions().front()->text(), "&File") << "not before";
  }
  EXPECT_EQ(chosenLanguage(), "de");
  {
    const German german;
    Story story("02_sphere", {.first_start = false});
    EXPECT_EQ(story.window().menuBar()->actions().front()->text(), "&Datei");
    EXPECT_TRUE(story.window().actions().find("language.de")->isChecked());
    EXPECT_TRUE(story.perform("language.en"));
    story.settle();
    story.find<QMessageBox>("dialog.language")->accept();
  }
  EXPECT_EQ(chosenLanguage(), "en");
  EXPECT_EQ(Story({}, {.first_start = false}).window().menuBar()->actions().front()->text(), "&File");
  QSettings().clear();
}

TEST(LanguageStory, LessonsAndScenesAreShownInGerman) {
  const German german;
  Story story("02_sphere");
  EXPECT_EQ(story.window().windowTitle(), QString("Kugel[*] – Underact"));
  ASSERT_TRUE(story.perform("lesson.start", QString("01_frames")));
  story.settle();
  EXPECT_TRUE(story.find<PageView>("panel.lessons.text")->toPlainText().contains("Koordinatensystem"));
  EXPECT_EQ(story.host().scene().title.find("Kugel"), std::string::npos) << "what runs and is recorded stays as it is";
}

TEST(LanguageStory, AFaultIsSaidInGermanAndItsFileStaysEnglish) {
  for (int kind = 1; kind < kFaultKinds; ++kind) {
    const Fault fault{static_cast<FaultKind>(kind), 12.0, 3.0};
    const QString english = sentenceText(describe(fault));
    EXPECT_EQ(english.toStdString(), describe(fault));
    const German german;
    const QString given = sentenceText(describe(fault));
    EXPECT_TRUE(given.contains("Die Kraft ist aus.")) << given.toStdString();
    EXPECT_NE(sentenceText(whatHappened(fault)), QString::fromStdString(whatHappened(fault)));
    EXPECT_NE(sentenceText(whatToDo(fault)), QString::fromStdString(whatToDo(fault)));
    EXPECT_EQ(german.missing().join('\n').toStdString(), "");
    EXPECT_EQ(describe(fault), english.toStdString());
  }
}

TEST(LanguageStory, EachMistakeInASceneIsSaidInGerman) {
  const German german;
  std::set<std::string> patterns;
  const QDir scenes(QFileInfo(shippedScene("02_sphere")).path());
  for (const QFileInfo& file : scenes.entryInfoList({"*.json"}, QDir::Files)) {
    const std::string path = file.filePath().toStdString();
    for (const std::string& text : spoiled(underact::test::fileText(path))) {
      const Result<scene::Description> read = scene::readScene(text, path);
      if (read) continue;
      for (const Problem& problem : read.problems()) {
        if (!patterns.insert(problem.sentence.pattern()).second) continue;
        EXPECT_NE(sentenceText(problem.sentence).toStdString(), problem.sentence);
      }
    }
  }
  EXPECT_GT(patterns.size(), 35U);
  EXPECT_EQ(german.missing().join('\n').toStdString(), "");
}

TEST(LanguageStory, AFileThatIsNotOpenedSaysWhyInGerman) {
  const German german;
  Story story("02_sphere");
  story.perform("scene.open", temporaryFile("broken.json", R"({"underact_scene": 1, "title": 3})"));
  story.settle();
  const QTableWidget* const table = story.find<QTableWidget>("dialog.problems.table");
  EXPECT_EQ(table->item(0, 3)->text().toStdString(),
            "Der Schlüssel „constraints“ fehlt; er ist hier nötig (eine Szene).");
  EXPECT_EQ(table->item(1, 3)->text().toStdString(),
            "Dies muss Text in doppelten Anführungszeichen sein; hier steht eine Zahl.");
}

TEST(LanguageStory, NumbersHaveACommaOnTheScreenAndBothAreUnderstood) {
  EXPECT_EQ(numberText(-1234.56, 1), QString(QChar(0x2212)) + "1234.6");
  const German german;
  EXPECT_EQ(numberText(-1234.56, 1), QString(QChar(0x2212)) + "1234,6");
  EXPECT_EQ(numberText(-0.04, 1), "0,0");
  EXPECT_EQ(typed(" 1.5"), 1.5);
  EXPECT_EQ(typed(QString(QChar(0x2212)) + "1,5"), -1.5);
  EXPECT_EQ(typed("1.000,5"), std::nullopt);
  Story story("12_line_pid");
  auto* number = story.find<QDoubleSpinBox>("panel.gains.kp.x.number");
  for (const char* text : {"0.45", "0,25"}) {
    story.type(number, text);
    EXPECT_EQ(number->value(), typed(text)) << text;
    EXPECT_TRUE(number->text().contains(',')) << number->text().toStdString();
    EXPECT_FALSE(number->text().contains('.')) << number->text().toStdString();
  }
}

TEST(LanguageStory, AFileHasTheSameBytesInEveryLanguage) {
  const QByteArray english = savedAfterAnEdit();
  EXPECT_TRUE(english.contains("0.35"));
  const German german;
  EXPECT_EQ(savedAfterAnEdit(), english);
}

TEST(LanguageStory, EachMenuHasEachLetterOnce) {
  for (const bool is_german : {true, false}) {
    std::optional<German> german;
    if (is_german) german.emplace();
    Story story("02_sphere");
    for (QMenu* menu : story.window().menuBar()->findChildren<QMenu*>()) {
      QSet<QChar> letters;
      for (const QAction* action : menu->actions()) {
        const qsizetype at = action->text().indexOf('&');
        if (at < 0 || menu->objectName() == "menu.recent") continue;
        const QChar letter = action->text()[at + 1].toLower();
        EXPECT_FALSE(letters.contains(letter)) << action->text().toStdString();
        letters.insert(letter);
      }
    }
  }
}

}  // namespace underact::gui::test
