#include <gtest/gtest.h>

#include <QAccessible>
#include <QLabel>
#include <QMessageBox>
#include <QProgressDialog>
#include <QTest>
#include <QToolTip>
#include <QWizard>

#include "app/gui/kit/accessible_widgets.h"

namespace underact::gui::test {
namespace {

const QString kHostile = R"(<link rel="stylesheet" href="/dev/zero"><b>bold</b> R&D &lt;)";

/// The labels of the window that say it; each must show it as text.
int plainLabels(QWidget& window) {
  window.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
  int count = 0;
  for (const QLabel* const label : window.findChildren<QLabel*>()) {
    if (!label->text().contains("<b>bold</b>")) continue;
    EXPECT_EQ(label->textFormat(), Qt::PlainText) << label->objectName().toStdString();
    count++;
  }
  return count;
}

TEST(PlainLabels, HtmlIsTextInLabelsMessagesProgressAndWizards) {
  QWidget window;
  new QLabel(kHostile, &window);
  QMessageBox box(QMessageBox::Warning, kHostile, kHostile);
  box.setInformativeText(kHostile);
  QProgressDialog progress(kHostile, "Cancel", 0, 1);
  QWizard wizard;
  auto* const page = new QWizardPage;
  page->setTitle(kHostile);
  page->setSubTitle(kHostile);
  wizard.addPage(page);
  EXPECT_EQ(plainLabels(window), 1);
  EXPECT_EQ(plainLabels(box), 2);
  EXPECT_EQ(plainLabels(progress), 1);
  EXPECT_EQ(plainLabels(wizard), 2);
  QToolTip::showText(wizard.mapToGlobal(QPoint(5, 5)), kHostile, &wizard);
  for (const QWidget* const tip : QApplication::topLevelWidgets()) {
    if (tip->inherits("QTipLabel")) EXPECT_EQ(qobject_cast<const QLabel*>(tip)->textFormat(), Qt::PlainText);
  }
  QToolTip::hideText();
}

TEST(PlainLabels, RichTextIsShownWhereItIsAskedFor) {
  QLabel label("<b>bold</b>");
  label.setTextFormat(Qt::RichText);
  label.show();
  EXPECT_EQ(label.textFormat(), Qt::RichText);
}

TEST(PlainLabels, AScreenReaderIsToldTheTextAlsoOfALabelThatIsNotShownYet) {
  makeWidgetsAccessible();
  QLabel label(kHostile);
  EXPECT_EQ(QAccessible::queryAccessibleInterface(&label)->text(QAccessible::Name), kHostile);
}

}  // namespace
}  // namespace underact::gui::test
