#include "app/gui/guide/guide_window.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QScrollBar>
#include <QTextBrowser>
#include <QTreeWidget>

#include "app/gui/guide/guide_tool.h"
#include "app/gui/kit/page_view.h"
#include "app/gui/model/settings.h"
#include "app/page/style.h"
#include "tests/gui/guide_pages.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

/// A story with the guide open and before all.
struct Reader : Story {
  explicit Reader(const QString& place = "start", const Beginning& beginning = {}) : Story("02_sphere", beginning) {
    EXPECT_TRUE(perform("help.guide", place));
    bringToFront(&guide());
  }
  GuideWindow& guide() { return *find<GuideWindow>("guide"); }
  PageView& page() { return *find<PageView>("guide.page"); }
  /// Waits for pictures that were asked for.
  bool hasPictures() {
    settle();
    return QTest::qWaitFor([this] { return page().picturesAwaited() == 0; }, 30'000);
  }
  QListWidget& hits() { return *find<QListWidget>("guide.hits"); }
  void keys(const QString& text) {
    for (const QChar letter : text) QTest::keyClick(guide().windowHandle(), letter.toLatin1());
  }
};

void savePicture(QWidget* widget, const QString& name) {
  const QString folder = QString(UNDERACT_BINARY) + "/pictures";
  QDir().mkpath(folder);
  EXPECT_TRUE(widget->grab().save(QString("%1/%2.png").arg(folder, name)));
}

}  // namespace

TEST(GuideWindowStory, F1OpensThePageForWhatHasTheFocus) {
  Story story("02_sphere");
  story.find("panel.feel.law")->setFocus();
  story.key(Qt::Key_F1);
  auto* window = story.find<GuideWindow>("guide");
  ASSERT_NE(window, nullptr);
  EXPECT_EQ(window->place(), QString("window#feel"));
  story.bringToFront(&story.window());
  story.view().setFocus();
  story.key(Qt::Key_F1);
  EXPECT_EQ(window->place(), QString("window#the-view"));
}

TEST(GuideWindowStory, EveryPanelAndEveryWidgetInItHasAPageThatIsThere) {
  Story story("02_sphere");
  for (const PanelRow& row : panelsOf(features())) {
    const QString name = QString("panel.%1").arg(row.key);
    const bool has_row = std::any_of(allPages().begin(), allPages().end(),
                                     [&](const HelpPage& page) { return name == QLatin1String(page.part); });
    EXPECT_TRUE(has_row) << name.toStdString() << ": the feature.cpp of its room names its page";
    const QWidget* panel = story.find(name);
    EXPECT_TRUE(isPlace(helpPageOf(panel, allPages()))) << name.toStdString();
    for (const QWidget* part : panel->findChildren<QWidget*>())
      EXPECT_TRUE(isPlace(helpPageOf(part, allPages()))) << part->objectName().toStdString();
  }
}

TEST(GuideWindowStory, ASearchByKeysFindsMarksAndOpens) {
  Reader reader;
  reader.key(Qt::Key_F, Qt::ControlModifier);
  EXPECT_TRUE(reader.find("guide.search")->hasFocus());
  reader.keys("hold to run");
  ASSERT_GT(reader.hits().count(), 0);
  EXPECT_TRUE(reader.hits().isVisible());
  EXPECT_TRUE(reader.hits().item(0)->text().contains("Hold to run"));
  reader.key(Qt::Key_Return);
  EXPECT_EQ(reader.guide().place(), QString("servo#hold-to-run"));
  EXPECT_FALSE(reader.page().extraSelections().isEmpty()) << "marks";
  const QString first = reader.page().textCursor().selectedText();
  EXPECT_FALSE(first.isEmpty());
  const int at = reader.page().textCursor().position();
  reader.key(Qt::Key_F3);
  EXPECT_NE(reader.page().textCursor().position(), at);
  reader.key(Qt::Key_F3, Qt::ShiftModifier);
  EXPECT_EQ(reader.page().textCursor().position(), at);
  savePicture(&reader.guide(), "guide_search");

  reader.key(Qt::Key_F, Qt::ControlModifier);
  reader.keys("nosuchwordatall");
  EXPECT_EQ(reader.hits().item(0)->text(), QString("Nothing was found."));
  reader.find<QLineEdit>("guide.search")->clear();
  EXPECT_TRUE(reader.find("guide.contents")->isVisible());
  EXPECT_TRUE(reader.page().extraSelections().isEmpty());
}

TEST(GuideWindowStory, ArrowKeysChooseAmongWhatWasFound) {
  Reader reader;
  ASSERT_TRUE(reader.perform("guide.search", "wall"));
  ASSERT_GT(reader.hits().count(), 2);
  reader.key(Qt::Key_Down);
  reader.key(Qt::Key_Down);
  reader.key(Qt::Key_Up);
  EXPECT_EQ(reader.hits().currentRow(), 1);
  reader.key(Qt::Key_Return);
  EXPECT_EQ(reader.guide().place(), reader.hits().item(1)->data(Qt::UserRole).toString());
}

TEST(GuideWindowStory, BackAndForwardGoThroughWhatWasRead) {
  Reader reader("start");
  EXPECT_FALSE(reader.find("guide.back")->isEnabled());
  reader.perform("help.guide", "energy");
  reader.perform("help.guide", "faults#not-tried");
  reader.key(Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(reader.guide().place(), QString("energy"));
  reader.key(Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(reader.guide().place(), QString("start"));
  EXPECT_FALSE(reader.find("guide.back")->isEnabled());
  reader.key(Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(reader.guide().place(), QString("energy"));
  reader.click(reader.find("guide.forward"));
  EXPECT_EQ(reader.guide().place(), QString("faults#not-tried"));
  reader.click(reader.find("guide.back"));
  reader.perform("help.guide", "lab");
  QTest::qWait(2500);
  EXPECT_FALSE(reader.find("guide.forward")->isEnabled()) << "another way was taken";
  reader.perform("help.guide", "no_such_page");
  EXPECT_EQ(reader.guide().place(), QString("lab"));
}

TEST(GuideWindowStory, LinksOpenScenesPagesAndActionsAndShowAddresses) {
  Reader reader("concepts");
  emit reader.page().anchorClicked(QUrl("scene:06_cylinder"));
  reader.settle();
  EXPECT_EQ(reader.window().document().scene().title, "Tilted cylinder");
  emit reader.page().anchorClicked(QUrl("energy.md"));
  EXPECT_EQ(reader.guide().place(), QString("energy"));
  emit reader.page().anchorClicked(QUrl("scenes.md#friction"));
  EXPECT_EQ(reader.guide().place(), QString("scenes#friction"));
  EXPECT_GT(reader.page().verticalScrollBar()->value(), 0);
  emit reader.page().anchorClicked(QUrl("action:layer.link_frames"));
  EXPECT_TRUE(reader.view().layers().link_frames);
  emit reader.page().anchorClicked(QUrl("scene:../../secret"));
  emit reader.page().anchorClicked(QUrl("file:///etc/passwd"));
  EXPECT_EQ(reader.window().document().scene().title, "Tilted cylinder");
  emit reader.page().anchorClicked(QUrl("https://underact.example/a?b=c"));
  auto* box = reader.find<QMessageBox>("dialog.address");
  ASSERT_NE(box, nullptr);
  EXPECT_TRUE(box->informativeText().contains("https://underact.example/a?b=c"));
  box->reject();
}

TEST(GuideWindowStory, ANotebookOpensAsACopyThatKeepsItsChanges) {
  Reader reader("python");
  QTextBrowser system;  // in the place of the desktop's: a URL is given to one of its methods
  QList<QUrl> opened;
  QObject::connect(&system, &QTextBrowser::anchorClicked, [&](const QUrl& url) { opened << url; });
  QDesktopServices::setUrlHandler("file", &system, "anchorClicked");
  const auto open = [&](const char* link) {
    emit reader.page().anchorClicked(QUrl(link));
    auto* button = reader.find<QAbstractButton>("dialog.notebook.open");
    ASSERT_NE(button, nullptr) << link;
    reader.click(button);
  };
  open("first_steps.ipynb");
  ASSERT_EQ(opened.size(), 1);
  QFile copy(opened.front().toLocalFile());
  EXPECT_TRUE(copy.fileName().endsWith("/Underact/notebooks/first_steps.ipynb"));
  ASSERT_TRUE(copy.open(QIODevice::ReadWrite)) << "it can be worked on";
  EXPECT_TRUE(copy.readAll().contains("nbformat"));
  copy.resize(0);
  copy.write("mine");
  copy.close();
  open("first_steps.ipynb");
  ASSERT_TRUE(copy.open(QIODevice::ReadOnly));
  EXPECT_EQ(copy.readAll(), QByteArray("mine"));
  EXPECT_EQ(opened.size(), 2);
  open("no_such.ipynb");
  EXPECT_EQ(opened.size(), 2);
  auto* problems = reader.find<QMessageBox>("dialog.notebook_problems");
  ASSERT_NE(problems, nullptr);
  problems->reject();
  QDesktopServices::unsetUrlHandler("file");
}

TEST(GuideWindowStory, EveryActionThatAPageLinksToIsOneOfTheWindows) {
  Story story({});
  int actions = 0;
  for (const guide::Entry& entry : theGuide().entries) {
    for (const page::Page::Link& link : entry.page.links) {
      if (link.to.rfind("action:", 0) != 0) continue;
      ++actions;
      EXPECT_NE(story.window().actions().find(QString::fromStdString(link.to.substr(7))), nullptr) << link.to;
    }
  }
  EXPECT_GT(actions, 2);
}

TEST(GuideWindowStory, PageZoomAndWhereItStoodAreRemembered) {
  {
    Reader reader("energy");
    reader.key(Qt::Key_Plus, Qt::ControlModifier);
    reader.key(Qt::Key_Plus, Qt::ControlModifier);
    reader.key(Qt::Key_Minus, Qt::ControlModifier);
    EXPECT_EQ(reader.guide().zoom(), 110);
  }
  EXPECT_EQ(readSettings().guide_page, QString("energy"));
  Story story("02_sphere", {.first_start = false});
  story.window().setFocus();
  ASSERT_TRUE(story.perform("guide.search", ""));
  EXPECT_EQ(story.find<GuideWindow>("guide")->place(), QString("energy"));
  EXPECT_EQ(story.find<GuideWindow>("guide")->zoom(), 110);
  story.bringToFront(story.find("guide"));
  story.key(Qt::Key_0, Qt::ControlModifier);
  EXPECT_EQ(story.find<GuideWindow>("guide")->zoom(), 100);
}

TEST(GuideWindowStory, EscIsStopInTheGuideTooAndTheGuideStays) {
  Reader reader;
  reader.perform("session.start");
  reader.run(500);
  EXPECT_EQ(reader.snapshot().mode, servo::Mode::Running);
  reader.key(Qt::Key_Escape);
  reader.run(500);
  EXPECT_EQ(reader.snapshot().mode, servo::Mode::Idle);
  EXPECT_TRUE(reader.guide().isVisible());
  reader.key(Qt::Key_W, Qt::ControlModifier);
  EXPECT_FALSE(reader.guide().isVisible());
}

TEST(GuideWindowStory, EveryPartHasANameForStoriesAndOneForScreenReadersAndTabReachesIt) {
  Reader reader;
  for (const char* name : {"guide.back", "guide.forward", "guide.search", "guide.smaller", "guide.larger",
                           "guide.contents", "guide.hits", "guide.page"}) {
    QWidget* part = reader.find(name);
    ASSERT_NE(part, nullptr);
    EXPECT_FALSE(part->accessibleName().isEmpty()) << name;
    EXPECT_NE(part->focusPolicy() & Qt::TabFocus, 0) << name;
  }
}

TEST(GuideWindowStory, EveryPageOpensAndIsNoWiderThanItsPlace) {
  Reader reader;
  for (const guide::Entry& entry : theGuide().entries) {
    ASSERT_TRUE(reader.perform("help.guide", QString::fromStdString(entry.name)));
    EXPECT_TRUE(reader.hasPictures()) << entry.name;
    const auto fits = [&] { return !reader.page().horizontalScrollBar()->isVisible(); };
    EXPECT_TRUE(QTest::qWaitFor(fits, kLong_ms)) << entry.name;  // a long page is laid out in steps
    EXPECT_EQ(reader.guide().windowTitle(), QString("%1 – Guide").arg(QString::fromStdString(entry.page.title)));
  }
}

TEST(GuideWindowStory, APageScrollsSidewaysWhereMoreThanItsMarginIsBeyondTheEdge) {
  constexpr int kMargin = 16;
  PageView page;
  page.resize(900, 300);
  page.showPage("$$" + QString("x + ").repeated(30) + "x$$", {});  // a formula is not broken
  page.show();
  int still = 0, scrolled = 0;
  for (int width = 900; width > 300; width -= 3) {
    page.resize(width, 300);
    QApplication::processEvents();
    const int beyond = page.horizontalScrollBar()->maximum();
    EXPECT_EQ(page.horizontalScrollBar()->isVisible(), beyond > kMargin) << width << ", " << beyond;
    if (beyond > 0) ++(beyond > kMargin ? scrolled : still);
  }
  EXPECT_GT(still, 3);
  EXPECT_GT(scrolled, 3);
}

TEST(GuideWindowStory, TextOfTwiceTheSizeIsNotCut) {
  const QFont default_value = QApplication::font();
  QFont large = default_value;
  large.setPointSizeF(2.0 * default_value.pointSizeF());
  QApplication::setFont(large);
  {
    Reader reader("course_jacobian");
    for (const char* name : {"guide.back", "guide.forward", "guide.smaller", "guide.larger", "guide.search"}) {
      const QWidget* part = reader.find(name);
      EXPECT_GE(part->width(), part->minimumSizeHint().width()) << name;
      EXPECT_GE(part->height(), QFontMetrics(large).height()) << name;
    }
    EXPECT_FALSE(reader.page().horizontalScrollBar()->isVisible());
    savePicture(&reader.guide(), "guide_large_text");
  }
  QApplication::setFont(default_value);
}

TEST(GuideWindowStory, PicturesAreShownAndFitThePageAlsoWhenItBecomesNarrower) {
  Reader reader("course_jacobian");
  for (const int width : {1040, 760}) {
    reader.guide().resize(width, 700);
    ASSERT_TRUE(reader.hasPictures());
    const QVariant image =
        reader.page().document()->resource(QTextDocument::ImageResource, QUrl("../pictures/guide/ellipsoids.png"));
    ASSERT_TRUE(image.canConvert<QImage>());
    EXPECT_GT(image.value<QImage>().width(), 200);
    EXPECT_EQ(image.value<QImage>().pixelColor(3, 3), Theme::light().background) << "the picture, not its empty place";
    EXPECT_LE(image.value<QImage>().width(), reader.page().viewport()->width() * reader.page().devicePixelRatioF());
    EXPECT_FALSE(reader.page().horizontalScrollBar()->isVisible()) << "nothing is wider than the page";
  }
}

TEST(GuideWindowStory, TheStaticPagesHaveTheWindowsColours) {
  const auto is_same = [](const std::string& written, const QColor& colour) {
    return QColor(QString::fromStdString(written)) == colour;
  };
  for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
    const QPalette palette = paletteOf(theme);
    const page::Colours colours = theme.dark ? page::darkColours() : page::lightColours();
    EXPECT_TRUE(is_same(colours.ink, palette.color(QPalette::Text)));
    EXPECT_TRUE(is_same(colours.ground, palette.color(QPalette::Base)));
    EXPECT_TRUE(is_same(colours.link, palette.color(QPalette::Link)));
  }
}

// To be looked at by people: build/.../pictures/guide_PAGE_THEME.png.
TEST(GuideWindowStory, PagesInBothThemes) {
  for (const char* theme : {"light", "dark"}) {
    Reader reader;
    reader.perform(QString("view.theme.") + theme);
    for (const char* name : {"start", "course_frames", "course_jacobian", "experiments", "scene_reference", "lab"}) {
      reader.perform("help.guide", name);
      EXPECT_TRUE(reader.hasPictures());
      reader.settle();
      savePicture(&reader.guide(), QString("guide_%1_%2").arg(name, theme));
    }
  }
}

// The pictures of the course: the view of an arm at rest, written anew with UNDERACT_UPDATE_PICTURES=1.
TEST(GuidePictures, OfTheCourse) {
  const QString made = QString(UNDERACT_BINARY) + "/pictures",
                kept = QString(UNDERACT_SOURCE) + "/resources/pictures/guide";
  for (const auto& [name, layers] :
       std::vector<std::pair<QString, QStringList>>{{"frames", {"link_frames"}},
                                                    {"solutions", {"ghosts"}},
                                                    {"ellipsoids", {"motion_ellipsoid", "force_ellipsoid"}}}) {
    Story story("01_point");
    story.perform("view.theme.light");
    for (const char* quiet : {"workspace", "force", "target"}) story.perform(QString("layer.%1").arg(quiet), false);
    for (const QString& layer : layers) story.perform("layer." + layer, true);
    for (const auto& [joint, degrees] : {std::pair(1, 15.0), std::pair(2, 40.0), std::pair(3, 25.0)})
      story.perform("joint.set", joint, degrees);
    story.run(3000);
    story.view().setHint({});
    story.view().setFixedSize(720, 480);
    story.perform("view.isometric");
    story.settle(400);
    const QImage image = story.view().picture();
    QDir().mkpath(made);
    EXPECT_TRUE(image.save(QString("%1/guide_%2.png").arg(made, name)));
    if (qEnvironmentVariableIsSet("UNDERACT_UPDATE_PICTURES")) {
      QDir().mkpath(kept);
      EXPECT_TRUE(image.save(QString("%1/%2.png").arg(kept, name)));
    }
    EXPECT_TRUE(QFile::exists(QString("%1/%2.png").arg(kept, name))) << name.toStdString();
  }
}

}  // namespace underact::gui::test
