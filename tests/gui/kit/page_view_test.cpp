#include "app/gui/kit/page_view.h"

#include <gtest/gtest.h>

#include <QScrollBar>
#include <QTest>

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

}  // namespace
}  // namespace underact::gui
