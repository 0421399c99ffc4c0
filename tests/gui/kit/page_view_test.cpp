#include "app/gui/kit/page_view.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QFile>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>

namespace underact::gui {
namespace {

/// A page that is longer than what is seen of it, with the focus.
struct Page {
  Page() {
    QString text;
    for (int line = 0; line < 60; ++line) text += QString("Line %1\n\n").arg(line);
    view.showPage(text, {});
    view.resize(300, 200);
    view.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
    view.activateWindow();
    view.setFocus();
    EXPECT_TRUE(QTest::qWaitFor([this] { return view.hasFocus(); }));
  }
  int at() { return view.verticalScrollBar()->value(); }
  PageView view;
};

TEST(PageView, ShowsNoCaretWhereNobodyCanWrite) {
  Page page;
  const QImage with_focus = page.view.viewport()->grab().toImage();
  page.view.clearFocus();
  EXPECT_EQ(page.view.viewport()->grab().toImage(), with_focus);
}

TEST(PageView, KeysMoveThePageAndWithShiftSelect) {
  Page page;
  QTest::keyClick(&page.view, Qt::Key_Down);
  const int line = page.at();
  EXPECT_GT(line, 0);
  QTest::keyClick(&page.view, Qt::Key_PageDown);
  EXPECT_GT(page.at(), line + 100);
  QTest::keyClick(&page.view, Qt::Key_End);
  EXPECT_EQ(page.at(), page.view.verticalScrollBar()->maximum());
  QTest::keyClick(&page.view, Qt::Key_Home);
  EXPECT_EQ(page.at(), 0);
  EXPECT_FALSE(page.view.textCursor().hasSelection());
  QTest::keyClick(&page.view, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_TRUE(page.view.textCursor().hasSelection());
}

/// A folder with pictures of a page, and with what is none. huge.png has 30 000 x 30 000 pixels by its header.
struct Folder {
  Folder() {
    QDir(root.path()).mkdir("page");
    QImage picture(40, 30, QImage::Format_RGB32);
    picture.fill(Qt::red);
    for (const char* const name : {"good.png", "good.jpg", "../outside.png"}) EXPECT_TRUE(picture.save(file(name)));
    EXPECT_TRUE(QFile::link(root.filePath("outside.png"), file("link.png")));
    EXPECT_EQ(mkfifo(file("pipe.png").toUtf8().constData(), 0600), 0);
    write("image.png", R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:x="http://www.w3.org/1999/xlink" width="9"
        height="9"><image width="9" height="9" x:href="/dev/zero"/></svg>)");
    write("large.png", QByteArray((8 << 20) + 1, 'x'));
    write("huge.png",
          QByteArray::fromHex(
              "89504e470d0a1a0a0000000d4948445200007530000075300802000000e9456fed0000000849444154789c0300000000"
              "01480689d2"));
  }
  QString file(const QString& name) const { return root.filePath("page/" + name); }
  void write(const QString& name, const QByteArray& content) const {
    QFile out(file(name));
    EXPECT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(content);
  }
  /// What is wrong with it; "": nothing.
  std::string wrong(const QString& name) const {
    const Result<QImage> read = readPagePicture({file(".").toStdString(), file(name).toStdString()}, {999, 999});
    return read ? "" : std::string(read.problems().front().sentence);
  }
  QTemporaryDir root;
};

bool hasCome(const PageView& view) {
  return QTest::qWaitFor([&view] { return view.picturesAwaited() == 0; }, 20'000);
}

TEST(PagePicture, IsARegularFileInTheFolderOfItsPageAndItsHeaderIsJudgedBeforeItIsDecoded) {
  const Folder folder;
  EXPECT_EQ(folder.wrong("good.png"), "");
  EXPECT_EQ(folder.wrong("../page/good.jpg"), "");
  for (const char* const name : {"link.png", "../outside.png", "../../../../../../dev/zero"})
    EXPECT_EQ(folder.wrong(name), "A picture must be in the folder of the file that shows it.") << name;
  EXPECT_EQ(folder.wrong("pipe.png").substr(0, 36), "This is a pipe, a device or a socket");
  EXPECT_EQ(folder.wrong("none.png").substr(0, 26), "The file cannot be opened:");
  EXPECT_EQ(folder.wrong("large.png").substr(0, 31), "The file is larger than 8 MiB; ");
  EXPECT_EQ(folder.wrong("huge.png"), "The picture has 30000 x 30000 pixels; make it smaller than 16 megapixels.");
  EXPECT_EQ(folder.wrong("image.png"), "The picture is damaged, or neither PNG nor JPEG.")
      << "an SVG, which names others";
  EXPECT_FALSE(readPagePicture({"", folder.file("good.png").toStdString()}, {9, 9}));
}

TEST(PageView, ShowsAStrangersPicturesOrWhyNot) {
  const Folder folder;
  PageView view;
  view.resize(400, 300);
  view.show();
  const QStringList others{"pipe.png",
                           "link.png",
                           "huge.png",
                           "/dev/zero",
                           "../outside.png",
                           "http://localhost:1/a.png",
                           "data:image/png;base64,iVBORw0KGgo="};
  view.showPage("![](good.png) ![](" + others.join(") ![](") + ")", folder.file("."));
  const auto picture = [&view](const QString& name) {
    return view.document()->resource(QTextDocument::ImageResource, QUrl(name)).value<QImage>();
  };
  EXPECT_EQ(picture("good.png").size(), QSize(1, 1)) << "nothing is read in the window's thread";
  EXPECT_EQ(view.picturesAwaited(), 8);
  ASSERT_TRUE(hasCome(view));
  EXPECT_EQ(picture("good.png").size(), QSize(40, 30));
  for (const QString& name : others) EXPECT_GT(picture(name).width(), 100) << "words: " << name.toStdString();
}

TEST(PageView, ALeftPagePutsNoPictureIntoTheNext) {
  const Folder folder;
  PageView view;
  view.show();
  view.showPage("![](good.png)", folder.file("."));
  view.showPage("![](good.jpg)", folder.file("."));
  ASSERT_TRUE(hasCome(view));
  {
    PageView gone;
    gone.show();
    gone.showPage("![](good.png)", folder.file("."));
  }
  QTest::qWait(50);  // what was on its way finds nobody
  EXPECT_EQ(view.picturesAwaited(), 0);
}

TEST(PageView, AStrangersTextIsCutWithAWordAndTheProgramsIsNot) {
  PageView view;
  const QString text = QString("a\n\n").repeated(5000);
  view.showPage(text, {});
  EXPECT_TRUE(view.toPlainText().endsWith("The text is cut here: it has more than 2000 parts."));
  EXPECT_LE(view.document()->blockCount(), 2001);
  view.showPage(text, {}, Author::Program);
  EXPECT_EQ(view.document()->blockCount(), 5000);
}

}  // namespace
}  // namespace underact::gui
